// SPDX-License-Identifier: Apache-2.0
// Says what the planner answers while the floating-point unit flushes denormals and while it does not round to nearest:
// "as reset ANSWER flushing ANSWER upward ANSWER toward zero ANSWER", and "none" for a mode that the machine lacks.
#include "answer.hpp"
#include "firmware/application.hpp"

namespace krait::firmware {
namespace {

// The control word of the floating-point unit with that mode, from the word at reset.
#if defined(__x86_64__)
using Word = std::uint32_t;
constexpr Word kFlush = 0x8040, kUp = 0x4000, kZero = 0x6000;
Word read() {
  Word word;
  __asm volatile("stmxcsr %0" : "=m"(word));
  return word;
}
void write(Word word) { __asm volatile("ldmxcsr %0" ::"m"(word) : "memory"); }
#elif defined(__aarch64__)
using Word = std::uint64_t;
constexpr Word kFlush = 1U << 24U, kUp = 1U << 22U, kZero = 3U << 22U;
Word read() {
  Word word;
  __asm volatile("mrs %0, fpcr" : "=r"(word));
  return word;
}
void write(Word word) { __asm volatile("msr fpcr, %0" ::"r"(word) : "memory"); }
#elif defined(__arm__) && defined(__ARM_FP)
using Word = std::uint32_t;
constexpr Word kFlush = 1U << 24U, kUp = 1U << 22U, kZero = 3U << 22U;
Word read() {
  Word word;
  __asm volatile("vmrs %0, fpscr" : "=r"(word));
  return word;
}
void write(Word word) { __asm volatile("vmsr fpscr, %0" ::"r"(word) : "memory"); }
#elif defined(__riscv_flen)
using Word = std::uintptr_t;
constexpr Word kFlush = 0, kUp = 3U << 5U, kZero = 1U << 5U;
Word read() {
  Word word;
  __asm volatile("frcsr %0" : "=r"(word));
  return word;
}
void write(Word word) { __asm volatile("fscsr %0" ::"r"(word) : "memory"); }
#else
using Word = std::uint32_t;
constexpr Word kFlush = 0, kUp = 0, kZero = 0;
Word read() { return 0; }
void write(Word) {}
#endif

const char* answer_with(Word mode) {
  if (mode == 0) return "none";
  const Word reset = read();
  write(reset | mode);
  const char* const answer = test::answer();
  write(reset);
  return answer;
}

}  // namespace

int run(const Board& board, int, const char* const*) {
  const char* const words[] = {"as reset ",         test::answer(),     " flushing ",
                               answer_with(kFlush), " upward ",         answer_with(kUp),
                               " toward zero ",     answer_with(kZero), "\n"};
  for (const char* word : words) board.port.log(board.port.context, word);
  return kDone;
}

}  // namespace krait::firmware
