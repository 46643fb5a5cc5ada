#include "input/reader/collection.hpp"

#include "input/input_file.hpp"
#include "input/nearest.hpp"
#include "input/text/node.hpp"
#include "input/text/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::cases {
namespace {

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Visits the strings of a list; anything else is a mistake.
template <class Take>
void for_each_text(const Node& node, Mistakes& mistakes, const Take& take) {
  if (node.type != NodeType::list)
    mistakes.add(node.place,
                 fmt::format("{} = {}, but must be a list of strings",
                             node.path, written(node)));
  for (const Node& item : node.list)
    if (item.type == NodeType::text)
      take(item);
    else
      mistakes.add(item.place, fmt::format("{} has the item {}, but must be a "
                                           "list of strings",
                                           node.path, written(item)));
}

void read_parts(const Node& node, const std::vector<std::string>& folders,
                Collection& collection, Mistakes& mistakes) {
  for_each_text(node, mistakes, [&](const Node& item) {
    if (!contains(folders, item.text))
      mistakes.add(item.place,
                   fmt::format("parts has \"{}\", but no "
                               "sub-folder with a case.toml has "
                               "this name; nearest: {}",
                               item.text, input::nearest(item.text, folders)));
    else if (contains(collection.parts, item.text))
      mistakes.add(item.place,
                   fmt::format("parts has \"{}\" twice", item.text));
    else
      collection.parts.push_back(item.text);
  });
  for (const std::string& folder : folders)
    if (!contains(collection.parts, folder))
      mistakes.add(node.place, fmt::format("parts lacks \"{}\", which is a "
                                           "sub-folder with a case.toml",
                                           folder));
}

void read_figures(const Node& table, Collection& collection,
                  Mistakes& mistakes) {
  if (!table.is_table()) {
    mistakes.add(table.place, "figures must be a table of parts");
    return;
  }
  for (const NodeEntry& entry : table.entries) {
    if (!contains(collection.parts, entry.key)) {
      mistakes.add(entry.node.place,
                   fmt::format("figures.{} is not a part; nearest: {}",
                               entry.key,
                               input::nearest(entry.key, collection.parts)));
      continue;
    }
    for_each_text(entry.node, mistakes, [&](const Node& item) {
      collection.figures.push_back({entry.key, item.text, item.place});
    });
  }
}

} // namespace

Collection read_collection(const std::filesystem::path& file,
                           const std::vector<std::string>& folders) {
  const Node root = parse_toml(
      input::read_input_file(file, input::largest_text_file), file.string());
  Mistakes mistakes;
  for (const NodeEntry& entry : root.entries)
    if (entry.key != "parts" && entry.key != "figures")
      mistakes.add(entry.node.place,
                   fmt::format("{} is unknown; allowed are parts and figures",
                               entry.key));
  Collection collection;
  if (const Node* const parts = root.find("parts"))
    read_parts(*parts, folders, collection, mistakes);
  else
    mistakes.add({file.string(), 0}, "parts is missing: the names of the "
                                     "sub-folders in their order");
  if (const Node* const figures = root.find("figures"))
    read_figures(*figures, collection, mistakes);
  mistakes.throw_if_any();
  return collection;
}

} // namespace asperity::cases
