# C++ without what needs an operating system or a heap: exceptions, run-time type information, locks around statics,
# destructors at exit, unwind tables, errno.
string(APPEND CMAKE_CXX_FLAGS_INIT
  " -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit -fno-unwind-tables"
  " -fno-asynchronous-unwind-tables -fno-math-errno")
