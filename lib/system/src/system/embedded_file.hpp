#pragma once

/// Puts a file's bytes into the program, at file scope: `name` is the first, `name##_end` the one after the last. C++20
/// has no #embed; the assembler has, in GCC and clang alike. `path` is a string literal; CMake names the file in
/// OBJECT_DEPENDS.
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
