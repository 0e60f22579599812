#pragma once

/// Puts the bytes of a file into the program; use it at file scope. `name` is the first byte, and `name##_end` is the
/// one after the last. C++20 has no #embed, so this uses the assembler's .incbin, which GCC and clang both have. `path`
/// is a string literal; name the file in OBJECT_DEPENDS in CMake, so that a change of it is noticed.
///
/// The names are global and hidden: Debian 12's linker for arm64 takes both ends of a file for its beginning if they
/// are local names that the compiler looks up in the global offset table.
// NOLINTBEGIN(bugprone-macro-parentheses): string literals are joined
#define DDTOOL_EMBED_FILE(name, path)                                   \
    asm(".pushsection .rodata\n"                                        \
        ".balign 8\n"                                                   \
        ".global " #name ", " #name                                     \
        "_end\n"                                                        \
        ".hidden " #name ", " #name "_end\n" #name                      \
        ":\n"                                                           \
        ".incbin \"" path "\"\n" #name                                  \
        "_end:\n"                                                       \
        ".popsection\n");                                               \
    extern "C" const char name[] __attribute__((visibility("hidden"))); \
    extern "C" const char name##_end[] __attribute__((visibility("hidden")))
// NOLINTEND(bugprone-macro-parentheses)
