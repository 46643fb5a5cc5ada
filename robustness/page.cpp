#include "robustness/page.hpp"

#include "base/shown_number.hpp"
#include "robustness/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::robustness {
namespace {

constexpr const char* head = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1"><title>Asperity: stability</title>
<style>
:root { color-scheme: light dark; --paper: #fff; --ink: #1b1f24; --soft: #59636e; --line: #d8dee4; --pale: #f6f8fa;
  --ok: #0a6b3d; --ok-pale: #f0f8f3; --bad: #b3261e; --bad-pale: #fdf3f2; }
@media screen and (prefers-color-scheme: dark) { :root { --paper: #15181c; --ink: #e4e8ec; --soft: #9aa5b1; --line: #363d45;
  --pale: #1e2328; --ok: #5fd39a; --ok-pale: #14271e; --bad: #ff8a80; --bad-pale: #2e1a19; } }
html { background: var(--paper); }
body { margin: 0 auto; padding: 2rem 1.6rem 4rem; max-width: 76rem; color: var(--ink);
  font-family: "Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif; line-height: 1.5; }
h1 { font-size: 1.7rem; margin: 0 0 .4rem; }
h2 { font-size: 1.2rem; margin: 2.4rem 0 .6rem; border-bottom: 1px solid var(--line); }
p, li { max-width: 52rem; }
.soft { color: var(--soft); }
.banner { padding: .7rem 1rem; border-left: 5px solid var(--ok); background: var(--ok-pale); font-weight: 600; }
.banner.bad { border-color: var(--bad); background: var(--bad-pale); }
table { display: block; overflow-x: auto; border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
th { text-align: left; color: var(--soft); border-bottom: 1.5px solid var(--ink); padding: .3rem .9rem .3rem 0; }
td { border-bottom: 1px solid var(--line); padding: .3rem .9rem .3rem 0; vertical-align: top; }
td.n, th.n { text-align: right; }
code { white-space: nowrap; font-size: .85rem; background: var(--pale); padding: .1rem .3rem; }
.wide { overflow-x: auto; }
svg text { font-family: inherit; fill: currentColor; } svg { max-width: 100%; height: auto; }
@media screen and (max-width: 44rem) { body { padding: 1rem 1rem 3rem; } svg { max-width: none; } code { white-space: normal; } }
@media print {
  body { max-width: none; padding: 0; font-size: 9pt; } .wide { overflow: visible; }
  table { display: table; width: 100%; font-size: 7.5pt; } th, td { padding-right: .4rem; overflow-wrap: anywhere; }
  code { white-space: normal; overflow-wrap: anywhere; } tr, svg { break-inside: avoid; } h2 { break-after: avoid; }
  .banner { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
</style></head><body>
)";

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text)
    safe += c == '<'   ? "&lt;"
            : c == '>' ? "&gt;"
            : c == '&' ? "&amp;"
            : c == '"' ? "&quot;"
                       : std::string(1, c);
  return safe;
}

/// One bin of one axis: a row and a column of the heat map.
struct Bin {
  std::string axis;
  std::string label;
  bool is_first = false; ///< first bin of its axis
};

std::vector<Bin> bins_of(const Matrix& matrix) {
  std::vector<Bin> bins;
  for (const Axis& axis : axes()) {
    bool is_first = true;
    for (const std::string& label : axis.labels)
      if (matrix.of(axis.name, label).all() > 0) {
        bins.push_back({axis.name, label, is_first});
        is_first = false;
      }
  }
  return bins;
}

/// Returns green if all instances are verified or refused, darker for more
/// instances; red according to the share of other outcomes; grey if everything
/// is refused.
std::string colour_of(const Counts& counts) {
  if (counts.all() == 0)
    return "#ffffff";
  if (counts.others() > 0)
    return fmt::format("hsl(4,75%,{:.0f}%)",
                       85.0 - 45.0 * counts.others() / counts.all());
  if (counts.of(Outcome::verified) == 0)
    return "#9aa4af";
  const double tone = std::min(1.0, std::log10(1.0 + counts.all()) / 3.0);
  return fmt::format("hsl(150,45%,{:.0f}%)", 92.0 - 52.0 * tone);
}

std::string title_of(const Bin& row, const Bin& column, const Counts& counts) {
  std::string title = row.axis + "=" + row.label;
  if (row.axis != column.axis || row.label != column.label)
    title += ", " + column.axis + "=" + column.label;
  for (int i = 0; i < n_outcomes; ++i) {
    const auto outcome = static_cast<Outcome>(i);
    if (counts.of(outcome) > 0)
      title += fmt::format("; {} {}", counts.of(outcome), name_of(outcome));
  }
  return escaped(title);
}

std::string heat_map(const Matrix& matrix) {
  constexpr int cell = 11;
  constexpr int margin = 190;
  const std::vector<Bin> bins = bins_of(matrix);
  const int side = margin + cell * static_cast<int>(bins.size()) + 20;
  std::string svg =
      fmt::format("<div class=\"wide\"><svg width=\"{0}\" "
                  "height=\"{0}\" viewBox=\"0 0 {0} {0}\" font-size=\"9\">\n",
                  side);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const Bin& row = bins[i];
    const int y = margin + cell * static_cast<int>(i);
    const std::string name =
        escaped(row.is_first ? row.axis + " " + row.label : row.label);
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}"
                       "</text><text transform=\"translate({},{}) "
                       "rotate(-90)\">{}</text>\n",
                       margin - 4, y + cell - 2, name, y + cell - 2, margin - 4,
                       name);
    for (std::size_t j = 0; j <= i; ++j) {
      const Bin& column = bins[j];
      const Counts counts =
          matrix.of(row.axis, row.label, column.axis, column.label);
      if (counts.all() > 0)
        svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" "
                           "height=\"{}\" fill=\"{}\"><title>{}</title>"
                           "</rect>\n",
                           margin + cell * static_cast<int>(j), y, cell - 1,
                           cell - 1, colour_of(counts),
                           title_of(row, column, counts));
    }
  }
  return svg + "</svg></div>\n";
}

std::string outcome_table(const Matrix& matrix) {
  std::string html = "<table><tr><th>family</th>";
  for (int i = 0; i < n_outcomes; ++i)
    html += fmt::format("<th class=\"n\">{}</th>",
                        name_of(static_cast<Outcome>(i)));
  html += "</tr>\n";
  for (const std::string& family : axes().front().labels) {
    html += "<tr><td>" + family + "</td>";
    const Counts counts = matrix.of("family", family);
    for (const int count : counts.by_outcome)
      html += fmt::format("<td class=\"n\">{}</td>", count);
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string instance_list(const std::vector<InstanceResult>& results,
                          const RunDescription& run) {
  std::string html =
      "<table><tr><th>problem instance</th><th>outcome</th></tr>\n";
  for (const auto& [instance, report] : results)
    html += fmt::format(
        "<tr><td><code>{} --instance {}</code></td><td><b>{}{}</b> {} "
        "iterations. {}<br><span class=\"soft\">{}</span></td></tr>\n",
        run.rerun, instance.index, name_of(report.outcome),
        report.check.empty() ? "" : ": " + report.check, report.iterations,
        escaped(report.reason), escaped(text_of(instance)));
  return html + "</table>\n";
}

std::string pair_table(const Matrix& matrix) {
  std::string html =
      "<table><tr><th>metamorphic relation</th><th class=\"n\">pairs</th><th "
      "class=\"n\">same bits</th><th class=\"n\">largest difference of the "
      "mean gaps, in units of the tolerance</th></tr>\n";
  for (const auto& [pair, counts] : matrix.relations())
    html += fmt::format("<tr><td>{}</td><td class=\"n\">{}</td><td "
                        "class=\"n\">{}</td><td class=\"n\">{:.3g}</td></tr>\n",
                        name_of(pair), counts.pairs, counts.same_bits,
                        counts.largest_difference);
  return html + "</table>\n";
}

std::string locking_html(const std::vector<LockingRow>& locking) {
  std::string html =
      "<table><tr><th class=\"n\">thickness [lengths]</th><th "
      "class=\"n\">nodes per wavelength</th><th class=\"n\">nu</th><th "
      "class=\"n\">Q1</th><th class=\"n\">Q2</th></tr>\n";
  for (const LockingRow& row : locking)
    html +=
        fmt::format("<tr><td class=\"n\">{:g}</td><td class=\"n\">{}</td><td "
                    "class=\"n\">{:g}</td><td class=\"n\">{:+.2f} %</td><td "
                    "class=\"n\">{:+.2f} %</td></tr>\n",
                    row.thickness, 32 / row.waves, row.poisson_ratio,
                    Shown{100.0 * row.q1}, Shown{100.0 * row.q2});
  return html + "</table>\n";
}

std::string verdict(const Matrix& matrix) {
  const Counts& total = matrix.total();
  return fmt::format(
      "<p class=\"banner{}\">{} problem instances: {} converged and verified, "
      "{} refused with a reason, {} with any other outcome.</p>\n",
      total.others() > 0 ? " bad" : "", total.all(),
      total.of(Outcome::verified), total.of(Outcome::refused), total.others());
}

} // namespace

std::string page_of(const Matrix& matrix, const RunDescription& run,
                    const std::vector<LockingRow>& locking) {
  std::string html = head;
  html += "<h1>Numerical stability</h1>\n" + verdict(matrix);
  html += fmt::format(
      "<p class=\"soft\"><code>{}</code>, commit {}, {}; {:.0f} s of wall "
      "time, {:.0f} s of CPU time in problem instances. Of the refused "
      "instances, {} are valid but for a wave that is shorter than their grid "
      "resolves; all others contain a deliberate flaw.</p>\n",
      escaped(run.rerun), escaped(run.commit), escaped(run.machine),
      run.wall_seconds, matrix.seconds(), matrix.sound_but_refused());
  html += "<h2>Outcomes</h2>\n" + outcome_table(matrix);
  html += "<h2>Neither verified nor refused</h2>\n";
  html += matrix.others().empty() ? "<p>None.</p>\n"
                                  : instance_list(matrix.others(), run);
  html +=
      "<h2>The matrix</h2>\n<p>Each cell stands for two axis values that occur "
      "in the same problem instance, the diagonal for a single value. Green: "
      "all verified or refused, darker with more instances. Grey: all refused. "
      "Red: some were neither. The counts are shown as tooltips.</p>\n" +
      heat_map(matrix);
  html +=
      "<h2>Metamorphic pairs</h2>\n<p>Units of length and pressure that are "
      "scaled by powers of two, and transforms on several threads, must give "
      "the same bits; units that are scaled by powers of ten must give the "
      "same solution within the tolerance of the solver.</p>\n" +
      pair_table(matrix);
  html += "<h2>Locking</h2>\n<p>Compliance of the finite-element block under a "
          "sinusoidal pressure, relative to that of the exact slab: negative "
          "values are too stiff.</p>\n" +
          locking_html(locking);
  html += "<h2>Verified with the most iterations</h2>\n" +
          instance_list(matrix.slowest(), run);
  return html + "</body></html>\n";
}

} // namespace asperity::robustness
