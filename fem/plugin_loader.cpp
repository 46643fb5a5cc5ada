#include "fem/plugin.hpp"

#include <dlfcn.h>
#include <filesystem>
#include <stdexcept>

namespace asperity::fem {
namespace {

using ModuleEntry = const FemModule* (*)();

/// The plugin is never closed, because its libraries do not support unloading.
const FemModule* open_module() {
  const std::filesystem::path here =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  std::string looked;
  for (const char* folder : {".", "../fem", "../../fem", "../lib/asperity"}) {
    const std::filesystem::path module =
        (here / folder / "asperity_fem.so").lexically_normal();
    if (!std::filesystem::exists(module)) {
      looked += "\n  " + module.string() + ": no such file";
      continue;
    }
    void* const handle = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const entry =
        handle != nullptr ? dlsym(handle, "asperity_fem_entry") : nullptr;
    if (entry != nullptr)
      return reinterpret_cast<ModuleEntry>(entry)();
    const char* const why = dlerror();
    looked += "\n  " + module.string() + ": " + (why != nullptr ? why : "?");
  }
  throw std::runtime_error(
      "The finite-element module could not be loaded; tried" + looked);
}

} // namespace

BlockContact block_contact(const mechanics::ContactSettings& settings,
                           const mechanics::Scales& scales) {
  return {settings.law, settings.penalty.in_si(scales), settings.tolerance,
          settings.max_iterations};
}

const FemModule& load_fem_module() {
  static const FemModule& instance = *open_module();
  return instance;
}

} // namespace asperity::fem
