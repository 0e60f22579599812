#include "native/shipped_model.hpp"

#include "base/fingerprint.hpp"
#include "native/load_model.hpp"

// C++20 has no #embed; the assembler has, in GCC and clang alike. DDTOOL_SHIPPED_MODEL is the file's path.
asm(".pushsection .rodata\n"
    ".balign 8\n"
    "ddtool_shipped_model:\n"
    ".incbin \"" DDTOOL_SHIPPED_MODEL
    "\"\n"
    "ddtool_shipped_model_end:\n"
    ".popsection\n");

extern "C" const char ddtool_shipped_model[];
extern "C" const char ddtool_shipped_model_end[];

namespace ddtool::native {
namespace {

std::string_view shipped_bytes() {
    return {ddtool_shipped_model, static_cast<std::size_t>(ddtool_shipped_model_end - ddtool_shipped_model)};
}

}  // namespace

std::unique_ptr<DegreeModel> shipped_model() { return load_model(shipped_bytes(), shipped_model_name); }

std::string shipped_model_fingerprint() { return Fingerprint().add(shipped_bytes()).hex(); }

}  // namespace ddtool::native
