#include "methods/surface_rows.hpp"

#include "ranks/workers.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/shells.hpp"
#include "surfaces/maps/statistics.hpp"

#include <fmt/format.h>

#include <utility>

namespace asperity::methods {
namespace {

SharedRows rows_of(const SurfaceSource& source, RootWork& root) {
  const Grid grid =
      root.value([&] { return surfaces::surface_grid(source.surface); });
  return {grid, *root.ranks(), row_bounds(grid, root.ranks()->size())};
}

/// What a surface without heights says of itself.
struct SurfaceNumbers {
  Grid grid;
  mechanics::Scales scales;
};

} // namespace

SurfaceRows::SurfaceRows(SurfaceSource source, RootWork& root, int threads,
                         std::shared_ptr<Kept> kept)
    : source_(std::move(source)),
      root_(root),
      threads_(threads),
      rows_(rows_of(source_, root)),
      whole_because_(root.value([&] {
        return surfaces::reason_for_whole(source_.surface,
                                          source_.highest_wavevector);
      })),
      kept_(std::move(kept)) {
  source_.grid = rows_.grid();
}

const SurfaceRows::Kept& SurfaceRows::kept() const {
  if (kept_->of == this)
    return *kept_;
  *kept_ = {};
  if (whole_because_.empty()) {
    kept_->heights = surfaces::build_rows(source_.surface, source_.realization,
                                          rows_, source_.highest_wavevector,
                                          threads_, &kept_->facts);
  } else {
    std::vector<double> whole;
    root_.act([&] { whole = built_map(source_, &kept_->facts).heights; });
    kept_->heights = rows_.scattered(whole);
  }
  kept_->of = this;
  return *kept_;
}

SurfaceOfCase SurfaceRows::described(double contact_modulus) const {
  const Kept& built = kept();
  SurfaceOfCase surface = described_surface(
      rows_.grid(), surfaces::statistics(rows_, built.heights, threads_),
      surfaces::spectral_shells(rows_, built.heights, threads_),
      contact_modulus);
  if (source_.surface.kind == mechanics::SurfaceKind::measured)
    surface.map_facts = built.facts;
  return surface;
}

std::string SurfaceRows::sentence() const {
  const int n_ranks = root_.ranks()->size();
  if (!whole_because_.empty())
    return fmt::format("rank 0 builds the whole surface, because {}, and sends "
                       "its rows to {} ranks",
                       whole_because_, n_ranks);
  return fmt::format("{} ranks {} the rows of the surface", n_ranks,
                     source_.surface.kind == mechanics::SurfaceKind::measured
                         ? "read"
                         : "generate");
}

std::vector<double> SurfaceRows::taken() const {
  static_cast<void>(kept());
  return std::exchange(*kept_, {}).heights;
}

void SurfaceRows::pass(const results::TakeValues& take) const {
  rows_.pass_to_rank_0(kept().heights, take);
}

BuildSurface surfaces_by_rows(RootWork& root, double contact_modulus,
                              int threads) {
  return [&root, contact_modulus, threads,
          kept = std::make_shared<SurfaceRows::Kept>()](
             const SurfaceSource& source) {
    const auto rows =
        std::make_shared<const SurfaceRows>(source, root, threads, kept);
    SurfaceOfCase surface = rows->described(contact_modulus);
    surface.rows = rows;
    return surface;
  };
}

BuildSurface surfaces_of_rank_0(RootWork& root, double contact_modulus,
                                bool sends_heights) {
  return [&root, contact_modulus, sends_heights](const SurfaceSource& source) {
    SurfaceOfCase surface;
    root.act([&] { surface = whole_surface(source, contact_modulus); });
    const auto [grid, scales] = root.value([&] {
      return SurfaceNumbers{surface.record.grid, surface.scales};
    });
    surface.record.grid = grid;
    surface.record.rms_height = scales.rms_height;
    surface.scales = scales;
    if (sends_heights)
      surface.record.heights =
          root.value([&] { return std::move(surface.record.heights); });
    return surface;
  };
}

} // namespace asperity::methods
