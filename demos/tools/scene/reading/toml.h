// toml++, which has asserts in headers.
#pragma once

// Files break what its parser asserts of keys, behind which an error stands all the same. With NDEBUG such an
// assert would be a promise to the compiler.
#define TOML_ASSERT(condition) static_assert(true)
#ifdef NDEBUG
#undef NDEBUG
#include <toml++/toml.h>
#define NDEBUG
#else
#include <toml++/toml.h>
#endif
