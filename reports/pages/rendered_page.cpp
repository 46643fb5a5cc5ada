#include "reports/pages/page_data.hpp"
#include "reports/report_template.hpp"

#include <string>
#include <string_view>

namespace asperity::reports {

std::string rendered_page(std::string_view page_template,
                          kainjow::mustache::data page) {
  const auto add_part = [&](const char* name, std::string_view text) {
    page.set(name,
             kainjow::mustache::partial{[text] { return std::string(text); }});
  };
  add_part("page_head", page_head);
  add_part("page_facts", page_facts);
  add_part("page_end", page_end);
  add_part("figure", figure_template);
  kainjow::mustache::mustache view{std::string(page_template)};
  return view.render(page);
}

} // namespace asperity::reports
