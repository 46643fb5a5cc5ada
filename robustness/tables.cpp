#include "base/json.hpp"
#include "robustness/axes.hpp"
#include "robustness/page.hpp"

#include <fmt/format.h>

#include <algorithm>

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
  return "seed,instance,outcome,check,reason,iterations,area fraction [1],"
         "mean gap [h_rms],pair same bits,pair difference [tolerance],"
         "CPU time [s],family,shape,law,penalty [E*/h],control,load [E* h' or "
         "h_rms],program,points,shortest wave [h],hurst,roll-off [waves],"
         "rms slope,length [m],contact modulus [Pa],nu,thickness [length],top,"
         "growth,gamma,metamorphic pair,flaw,degree,coating stiffness [E],"
         "coating thickness [thickness],path,threads,sides,linear solver,"
         "modulus ratio [1],mesh,counter-body,counter radius [length],"
         "counter modulus [E]\n";
}

std::string csv_line(const InstanceResult& result) {
  const auto& [instance, report] = result;
  const std::string pair_bits =
      report.has_pair ? (report.has_same_bits ? "yes" : "no") : "";
  std::string line = fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{:.3f},", instance.seed, instance.index,
      name_of(report.outcome), report.check, quoted(report.reason),
      report.iterations, report.area, report.reduced_gap, pair_bits,
      report.pair_difference, report.seconds);
  line +=
      fmt::format("{},{},{},{},{},{},{},{},", name_of(instance.family),
                  name_of(instance.shape), name_of(instance.law),
                  instance.penalty, name_of(instance.control), instance.load,
                  name_of(instance.program), instance.points);
  line += fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},"
      "{},{},{},{},{},{},{}\n",
      instance.shortest_wave, instance.hurst, instance.roll_off,
      instance.rms_slope, instance.length, instance.contact_modulus,
      instance.poisson_ratio, instance.thickness,
      name_of(instance.far_boundary), instance.growth, instance.gamma,
      name_of(instance.relation), name_of(instance.flaw), instance.degree,
      instance.coating_stiffness, instance.coating_thickness,
      name_of(instance.path), instance.threads,
      instance.has_free_sides ? "free" : "periodic",
      name_of(instance.linear_solver), instance.modulus_ratio,
      instance.family == Family::full_block ? name_of(instance.mesh) : "",
      name_of(instance.counter), instance.counter_radius,
      instance.counter_stiffness);
  return line;
}

std::string json_of(const Matrix& matrix, const RunDescription& run,
                    const std::vector<LockingRow>& locking) {
  json root;
  root["command"] = run.rerun;
  root["commit"] = run.commit;
  root["machine"] = run.machine;
  root["seed"] = run.seed;
  root["wall_seconds"] = run.wall_seconds;
  root["cpu_seconds"] = matrix.seconds();
  root["instances"] = matrix.total().all();
  root["anything_else"] = matrix.total().others();
  root["outcomes"] = counts_json(matrix.total());
  for (const Axis& axis : axes())
    for (const std::string& label : axis.labels)
      if (const Counts counts = matrix.of(axis.name, label); counts.all() > 0)
        root["axes"][axis.name][label] = counts_json(counts);
  root["others"] = json::array();
  for (const auto& [instance, report] : matrix.others())
    root["others"].push_back({{"instance", instance.index},
                              {"outcome", name_of(report.outcome)},
                              {"check", report.check},
                              {"reason", report.reason},
                              {"words", text_of(instance)}});
  for (const auto& [pair, counts] : matrix.relations())
    root["metamorphic_pairs"][name_of(pair)] = {
        {"pairs", counts.pairs},
        {"same_bits", counts.same_bits},
        {"largest_difference_over_tolerance", counts.largest_difference}};
  for (const LockingRow& row : locking)
    root["locking"].push_back({{"poisson_ratio", row.poisson_ratio},
                               {"thickness", row.thickness},
                               {"waves", row.waves},
                               {"q1", row.q1},
                               {"q2", row.q2}});
  return text_of_json(root, 2) + "\n";
}

} // namespace asperity::robustness
