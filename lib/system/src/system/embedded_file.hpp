#pragma once

/// Puts the bytes of a file into the program; use it at file scope. `name` is the first byte, and `name##_end` is the
/// one after the last. C++20 has no #embed, so this uses the assembler's .incbin, which GCC and clang both have. `path`
/// is a string literal; name the file in OBJECT_DEPENDS in CMake, so that a change of it is noticed.
// NOLINTBEGIN(bugprone-macro-parentheses): string literals are joined
#define DDTOOL_EMBED_FILE(name, path)  \
    asm(".pushsection .rodata\n"       \
        ".balign 8\n" #name            \
        ":\n"                          \
        ".incbin \"" path "\"\n" #name \
        "_end:\n"                      \
        ".popsection\n");              \
    extern "C" const char name[];      \
    extern "C" const char name##_end[]
// NOLINTEND(bugprone-macro-parentheses)
