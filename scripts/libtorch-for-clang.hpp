// scripts/check-style includes this file before everything else when Clang reads code that uses LibTorch. In LibTorch
// 1.13, ATen/core/List.h uses std::vector<IValue> while IValue is incomplete (PyTorch issue 97689). GCC accepts this,
// but in C++20 mode Clang instantiates constexpr functions at once. Therefore std::vector of libstdc++ 12 is read here
// without constexpr. This is for analysis only, because std::fill over std::vector<bool> loses its definition.
#pragma once

#include <algorithm>
#include <memory>
#include <string>

#undef _GLIBCXX20_CONSTEXPR
#define _GLIBCXX20_CONSTEXPR
#define __fill_a1(...) __fill_a1_without_constexpr(__VA_ARGS__)  // it was declared as constexpr above
#include <vector>
#undef __fill_a1
#undef _GLIBCXX20_CONSTEXPR
#define _GLIBCXX20_CONSTEXPR constexpr
