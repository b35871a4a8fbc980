// SPDX-License-Identifier: Apache-2.0
// krait: from a map to a plan on a workstation.
#include <cstdio>
#include <exception>
#include <new>

#include "host/cli/commands.hpp"
#include "host/input/parse_error.hpp"
#include "host/input/printed_out.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

constexpr const char* kAbout =
    "Plans collision-free, dynamically feasible motions for mobile robots.\n\n"
    "A first plan:\n"
    "  krait scene openings -o openings.json      (or your own map: krait compile --help)\n"
    "  krait compile openings.json -o openings.krait\n"
    "  krait plan openings.krait --robot snake:15 -o plan.json --html plan.html\n"
    "  krait verify openings.json plan.json --robot snake:15\n"
    "krait plan compiles a map itself where it is given one in place of a scene file: krait plan openings.json\n";

int complain(const std::string& what) {
  std::fprintf(stderr, "krait: %s\n", safe_to_print(what).c_str());
  return kBadInput;
}

// What is not understood is named before what is missing: a slip of the first kind often causes the second.
std::string complaint_of(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  const std::string help = commands.empty() ? "krait --help" : "krait " + commands.front()->get_name() + " --help";
  const std::vector<std::string> strange = app.remaining(true);
  if (strange.empty() && commands.empty() && error.get_name() == "RequiredError")
    return "give a command (see " + help + ")";
  if (strange.empty()) return line_of(error) + " (see " + help + ")";
  return (commands.empty() ? "no such command: " : "not expected here: ") + strange.front() + " (see " + help + ")";
}

// Exit code `code`, unless what was printed has got lost.
int after_printing(int code) {
  if (printed_out()) return code;
  return complain(kPrintingFailed);
}

int run(int argc, char** argv) {
  CLI::App app(kAbout, "krait");
  app.set_version_flag("--version", std::string("krait ") + KRAIT_VERSION);
  app.footer(
      "Exit codes: 0 done, 1 an honest no (no plan, or a plan that does not hold), 2 bad input, 3 a bug of krait.");
  app.require_subcommand(1);
  add_compile(app, argv[0]);
  add_info(app);
  add_plan(app, argv[0]);
  add_verify(app);
  add_scene(app);
  add_export(app);
  add_robot(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return after_printing(app.exit(success));
  } catch (const CLI::ParseError& error) {
    return complain(complaint_of(app, error));
  } catch (const Exit& exit) {
    return after_printing(exit.code);
  } catch (const InputError& error) {
    return complain(error.what());
  } catch (const std::bad_alloc&) {
    return complain("not enough memory on this machine for that (a smaller --memory, or a smaller map?)");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "krait: internal error, please report it: %s\n", safe_to_print(error.what()).c_str());
    return kOwnBug;
  }
  return after_printing(kDone);
}

}  // namespace
}  // namespace krait::host

int main(int argc, char** argv) { return krait::host::run(argc, argv); }
