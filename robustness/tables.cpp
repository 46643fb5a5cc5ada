#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "robustness/axes.hpp"
#include "robustness/page.hpp"

namespace asperity::robustness {
namespace {

using nlohmann::json;

std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return '"' + text + '"';
}

json counts_json(const Counts& counts) {
  json object;
  for (int i = 0; i < n_outcomes; ++i)
    object[name_of(static_cast<Outcome>(i))] =
        counts.of(static_cast<Outcome>(i));
  return object;
}

} // namespace

std::string csv_header() {
  return "seed,scene,outcome,check,reason,iterations,area fraction [1],"
         "mean gap [h_rms],twin same bits,twin difference [tolerance],"
         "CPU time [s],family,shape,law,penalty [E*/h],control,load [E* h' or "
         "h_rms],program,points,shortest wave [h],hurst,roll-off [waves],"
         "rms slope,length [m],contact modulus [Pa],nu,thickness [length],top,"
         "growth,gamma,twin,flaw,degree,coating stiffness [E],"
         "coating thickness [thickness],path,threads\n";
}

std::string csv_line(const SceneResult& result) {
  const auto& [scene, report] = result;
  const std::string twin_bits =
      report.has_twin ? (report.has_same_bits ? "yes" : "no") : "";
  std::string line = fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{:.3f},", scene.seed, scene.index,
      name_of(report.outcome), report.check, quoted(report.reason),
      report.iterations, report.area, report.reduced_gap, twin_bits,
      report.twin_difference, report.seconds);
  line += fmt::format("{},{},{},{},{},{},{},{},", name_of(scene.family),
                      name_of(scene.shape), name_of(scene.law), scene.penalty,
                      name_of(scene.control), scene.load,
                      name_of(scene.program), scene.points);
  line += fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
      scene.shortest_wave, scene.hurst, scene.roll_off, scene.rms_slope,
      scene.length, scene.contact_modulus, scene.poisson_ratio, scene.thickness,
      name_of(scene.top), scene.growth, scene.gamma, name_of(scene.twin),
      name_of(scene.flaw), scene.degree, scene.coating_stiffness,
      scene.coating_thickness, name_of(scene.path), scene.threads);
  return line;
}

std::string json_of(const Matrix& matrix, const RunWords& run,
                    const std::vector<LockingRow>& locking) {
  json root;
  root["command"] = run.rerun;
  root["commit"] = run.commit;
  root["machine"] = run.machine;
  root["seed"] = run.seed;
  root["wall_seconds"] = run.wall_seconds;
  root["cpu_seconds"] = matrix.seconds();
  root["scenes"] = matrix.total().all();
  root["anything_else"] = matrix.total().others();
  root["outcomes"] = counts_json(matrix.total());
  for (const Axis& axis : axes())
    for (const std::string& label : axis.labels)
      if (const Counts counts = matrix.of(axis.name, label); counts.all() > 0)
        root["axes"][axis.name][label] = counts_json(counts);
  root["others"] = json::array();
  for (const auto& [scene, report] : matrix.others())
    root["others"].push_back({{"scene", scene.index},
                              {"outcome", name_of(report.outcome)},
                              {"check", report.check},
                              {"reason", report.reason},
                              {"words", in_words(scene)}});
  for (const auto& [twin, counts] : matrix.twins())
    root["twins"][name_of(twin)] = {
        {"pairs", counts.pairs},
        {"same_bits", counts.same_bits},
        {"largest_difference_over_tolerance", counts.largest_difference}};
  for (const LockingRow& row : locking)
    root["locking"].push_back({{"poisson_ratio", row.poisson_ratio},
                               {"thickness", row.thickness},
                               {"waves", row.waves},
                               {"q1", row.q1},
                               {"q2", row.q2}});
  return root.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

} // namespace asperity::robustness
