#include "base/json.hpp"

namespace asperity {

using Json = nlohmann::ordered_json;

std::string text_of_json(const Json& value, int indent) {
  return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string text_of_json(const nlohmann::json& value, int indent) {
  return value.dump(indent, ' ', false,
                    nlohmann::json::error_handler_t::replace);
}

std::string ascii_of_json(const Json& value) {
  return value.dump(-1, ' ', true, Json::error_handler_t::replace);
}

Json json_of_text(std::string_view text) {
  return Json::parse(text);
}

} // namespace asperity
