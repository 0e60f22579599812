// Comes before everything else when scripts/check-style reads code that uses LibTorch. LibTorch 1.13's ATen/core/List.h
// uses std::vector<IValue> while IValue is incomplete (PyTorch issue 97689). GCC lets it pass, but Clang in C++20
// mode instantiates constexpr functions at once. So libstdc++ 12's std::vector is read here without constexpr.
// For analysis alone: std::fill over std::vector<bool> loses its definition.
#pragma once

#include <algorithm>
#include <memory>
#include <string>

#undef _GLIBCXX20_CONSTEXPR
#define _GLIBCXX20_CONSTEXPR
#define __fill_a1(...) __fill_a1_without_constexpr(__VA_ARGS__)  // it was declared constexpr above
#include <vector>
#undef __fill_a1
#undef _GLIBCXX20_CONSTEXPR
#define _GLIBCXX20_CONSTEXPR constexpr
