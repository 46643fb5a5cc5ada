#include "app/plan/finished_output.hpp"

#include "app/cache/case_keys.hpp"
#include "app/methods/chosen.hpp"
#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"
#include "base/read_file.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>

namespace asperity::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* list_name = "output.json";

std::string hash_of_file(const fs::path& file) {
  return content_hash(read_file(file, INT64_MAX));
}

bool is_listed(const fs::path& file) {
  const std::string name = file.filename().string();
  return !name.starts_with('.') && name != list_name &&
         name != "result.previous.h5";
}

} // namespace

std::string output_key(const cases::Case& contact_case,
                       const RunOptions& options, const std::string& extras) {
  // Cache keys leave out what a report shows: its program, titles, comments and
  // expectations.
  std::string text = hash_of_file("/proc/self/exe") + "\n" + extras + "\n" +
                     contact_case.name + "\n" + contact_case.text + "\n" +
                     options.reference + "\n";
  const CaseKeys keys(contact_case, program_identity());
  for (const cases::MethodSpec& method :
       chosen_methods(contact_case, options.methods, options.is_exact)) {
    text += method.name + "\n";
    for (int r = 0; r < n_realizations(contact_case, method); ++r)
      text += keys.steps(method, r).back() + "\n";
  }
  return content_hash(text);
}

void record_output(const fs::path& folder, const std::string& key) {
  std::map<std::string, std::string> hashes;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && is_listed(entry.path()))
      hashes[fs::relative(entry.path(), folder).string()] =
          hash_of_file(entry.path());
  const Json list = {{"format", "asperity-output"},
                     {"format_version", 1},
                     {"key", key},
                     {"sha256", hashes}};
  write_file_atomically(folder / list_name, list.dump(2) + "\n");
}

bool has_output(const fs::path& folder, const std::string& key) {
  if (!fs::is_regular_file(folder / list_name))
    return false;
  try {
    const Json list = Json::parse(read_file(folder / list_name, 1 << 26));
    if (list.at("key") != key)
      return false;
    for (const auto& [file, hash] : list.at("sha256").items())
      if (hash_of_file(folder / file) != hash)
        return false;
    return true;
  } catch (const Json::exception&) {
    return false; // edited by hand
  } catch (const FileError&) {
    return false; // a file is missing
  }
}

} // namespace asperity::app
