// Lists what a run did not compute, as rows of the page.
#include "reports/pages/page_data.hpp"

namespace asperity::reports {

kainjow::mustache::list skipped_rows(const results::Result& result) {
  kainjow::mustache::list rows;
  for (const results::Skipped& one : result.skipped) {
    kainjow::mustache::data row;
    row.set("what", one.what);
    row.set("why", one.why);
    rows.push_back(row);
  }
  return rows;
}

} // namespace asperity::reports
