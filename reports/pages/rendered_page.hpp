#pragma once

// Renders a page from JSON, the same that a program reads where it is published
// as a file. Numbers are formatted here and nowhere else: a template says how.

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace asperity::reports {

/// Returns the page of a mustache template. Every template may name the parts
/// that all pages share: {{> page_head}}, which ends with the style sheet and
/// shows the `page_title`, {{> page_facts}}, {{> figure}} and {{> page_end}}.
///
/// A section of a null, an empty text or a number that is not finite is left
/// out; an array `rows` also sets `has_rows`. A number has its format behind a
/// bar, and without one all its digits:
///
///     {{gap|4g}}          as by {:.4g} of fmt; "–" if it is null
///     {{gap|4g e9 nm}}    times 1e9, with a unit
///     {{gap|4m}}          in metres, with a prefix: "5.98 nm"; also N and Pa
///     {{gap|unit}}        the same in the unit that its object has as `unit`
///     {{gap|key}}         all digits; what is missing is sorted last
///     {{value|±}}         with the half_width_95 of its object: "0.41 ± 0.02";
///                         |±4g e9: in this format
std::string rendered_page(std::string_view page_template,
                          nlohmann::ordered_json page);

/// Returns the members of an object as an array: those that are objects with
/// their names as `key`, others as {"key", "value"}.
nlohmann::ordered_json items_of(const nlohmann::ordered_json& object);

} // namespace asperity::reports
