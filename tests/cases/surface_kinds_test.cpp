// Tests of [surface]: the required and the refused keys of each kind.
#include "input/reader/vocabulary.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

#include <string>

namespace asperity::cases::surface_kinds_test {

mechanics::SurfaceSpec surface_of(const std::string& keys) {
  return read_case_text(shape_case(keys), "cases/it/case.toml").surface;
}

TEST(SurfaceKinds, ReadTheExactShapes) {
  const std::string grid = "length = 1e-3\npoints = 64\n";

  const mechanics::SurfaceSpec sphere =
      surface_of("kind = \"sphere\"\nradius = \"10 length\"\n" + grid);
  const mechanics::SurfaceSpec wave =
      surface_of("kind = \"wave-2d\"\namplitude = \"0.5 "
                 "h\"\nwavelength = \"0.25 length\"\n" +
                 grid);

  EXPECT_EQ(sphere.kind, mechanics::SurfaceKind::sphere);
  EXPECT_DOUBLE_EQ(sphere.radius, 1e-2);
  EXPECT_EQ(wave.kind, mechanics::SurfaceKind::wave_2d);
  EXPECT_DOUBLE_EQ(wave.amplitude, 0.5e-3 / 64);
  EXPECT_DOUBLE_EQ(wave.wavelength, 0.25e-3);
}

TEST(SurfaceKinds, ReadAPunch) {
  const mechanics::SurfaceSpec punch =
      surface_of("kind = \"punch\"\nlength = 1e-3\npoints = 64\nradius = "
                 "\"0.2 length\"\nrecess = 1e-6\ntilt = 1e-4\n");

  EXPECT_EQ(punch.kind, mechanics::SurfaceKind::punch);
  EXPECT_DOUBLE_EQ(punch.radius, 0.2e-3);
  EXPECT_EQ(punch.recess, 1e-6);
  EXPECT_EQ(punch.tilt, 1e-4);
}

TEST(SurfaceKinds, ReadAConeAndARoundedPunch) {
  const std::string grid = "length = 1e-3\npoints = 64\n";
  const mechanics::SurfaceSpec cone =
      surface_of("kind = \"cone\"\nslope = 0.05\n" + grid);
  const std::string punch =
      "kind = \"rounded-punch\"\nedge_radius = \"10 length\"\n" + grid;

  EXPECT_EQ(cone.kind, mechanics::SurfaceKind::cone);
  EXPECT_EQ(cone.slope, 0.05);
  EXPECT_DOUBLE_EQ(surface_of(punch + "radius = 1e-4\n").edge_radius, 1e-2);
  EXPECT_NE(mistakes_of(shape_case(punch + "radius = \"0.5 length\"\n"))
                .find("must be less than half of length"),
            std::string::npos);
}

TEST(SurfaceKinds, RefuseAPunchWithoutSurroundings) {
  const std::string punch = "kind = \"punch\"\nlength = 1e-3\npoints = 64\n"
                            "recess = 1e-6\n";
  EXPECT_NE(mistakes_of(shape_case(punch + "radius = \"0.5 length\"\n"))
                .find("must be less than half of length"),
            std::string::npos);
  EXPECT_NE(mistakes_of(shape_case(punch + "radius = 1e-4\ntilt = 0.05\n"))
                .find("must be less than recess over radius"),
            std::string::npos);
}

TEST(SurfaceKinds, ReadAMapBesideTheCase) {
  const mechanics::SurfaceSpec map =
      surface_of("kind = \"measured\"\nfile = \"map.txt\"\n"
                 "format = \"plain\"\nlevel = \"bow\"\n"
                 "edges = \"mirror\"\nlength = \"20 um\"\n"
                 "height_unit = \"1 nm\"\n");

  EXPECT_EQ(map.file, "cases/it/map.txt");
  EXPECT_EQ(map.format, "plain");
  EXPECT_EQ(map.level, mechanics::Levelling::bow);
  EXPECT_EQ(map.edges, mechanics::Edges::mirror);
  EXPECT_EQ(map.length, 20e-6);
  EXPECT_EQ(map.height_unit, 1e-9);
  EXPECT_FALSE(map.points);
}

TEST(SurfaceKinds, LeaveAnAbsolutePathAsItIs) {
  EXPECT_EQ(surface_of("kind = \"spectrum\"\nfile = \"/a/c.txt\"\n"
                       "length = 1e-6\npoints = 8\nseed = 1\n")
                .file,
            "/a/c.txt");
}

TEST(SurfaceKinds, RefuseWhatAMapDoesNotNeed) {
  EXPECT_EQ(
      mistakes_of(
          shape_case("kind = \"measured\"\nfile = \"m\"\nlevel = \"none\"\n"
                     "edges = \"mirror\"\npoints = 8\nseed = 3\n")),
      "  case.toml:7: surface.points = 8 does not apply to kind = \"measured\" "
      "(the file determines the points, and nothing in it is random); it "
      "belongs to self-affine, spectrum, sphere, wave-1d, wave-2d, punch, "
      "cone, "
      "rounded-punch\n"
      "  case.toml:8: surface.seed = 3 does not apply to kind = \"measured\" "
      "(the file determines the points, and nothing in it is random); it "
      "belongs to self-affine, spectrum\n");
}

TEST(SurfaceKinds, RequireTheSizeOfAPlainMapOnly) {
  const std::string map = "kind = \"measured\"\nfile = \"m\"\n"
                          "level = \"none\"\nedges = \"periodic\"\n";

  EXPECT_EQ(
      mistakes_of(shape_case(map + "format = \"plain\"\n")),
      "  case.toml:2: surface.length is missing, which a plain map does not "
      "contain: a number [m] or a string with one of: m, mm, um, nm, angstrom\n"
      "  case.toml:2: surface.height_unit is missing, which a plain map does "
      "not contain: a number [m] or a string with one of: m, mm, um, nm, "
      "angstrom\n");
  EXPECT_EQ(
      mistakes_of(shape_case(map + "format = \"gwyddion\"\nlength = 1.0\n")),
      "  case.toml:8: surface.length = 1, but a gwyddion map contains it: "
      "remove this key\n");
}

TEST(SurfaceKinds, RequireTheLevellingOfAMap) {
  EXPECT_EQ(mistakes_of(shape_case("kind = \"measured\"\nfile = \"m\"\n")),
            "  case.toml:2: surface.level is missing: none | plane | bow | "
            "sphere | cylinder\n");
}

// A map is mirrored unless the case states otherwise; a windowed map, whose
// power differs, is used in contact only where the case confirms it.
TEST(SurfaceKinds, MirrorAMapAndUseAWindowedOneOnlyIfConfirmed) {
  const std::string map = "kind = \"measured\"\nfile = \"m\"\n"
                          "level = \"none\"\n";
  const std::string window = map + "edges = \"window\"\n";

  EXPECT_EQ(surface_of(map).edges, mechanics::Edges::mirror);
  EXPECT_EQ(surface_of(map + "edges = \"periodic\"\n").edges,
            mechanics::Edges::periodic);
  EXPECT_EQ(surface_of(window + "press_windowed_map = true\n").edges,
            mechanics::Edges::window);
  EXPECT_EQ(mistakes_of(shape_case(window)),
            "  case.toml:6: surface.edges = \"window\", but this needs "
            "press_windowed_map = true: a window is meant for spectra, and the "
            "windowed map has 9/64 of the measured power and about 3/8 of the "
            "rms height and slope; edges = \"mirror\" preserves both\n");
  EXPECT_EQ(mistakes_of(shape_case(map + "press_windowed_map = true\n")),
            "  case.toml:6: surface.press_windowed_map = true, but this key "
            "applies only to edges = \"window\"\n");
}

TEST(SurfaceKinds, CutAMapOffAtAWavelengthOrItsNoise) {
  const std::string map = "kind = \"measured\"\nfile = \"m\"\n"
                          "level = \"none\"\ncut_off = ";
  EXPECT_EQ(surface_of(map + "\"600 nm\"\n").cut_off, 600e-9);
  EXPECT_EQ(surface_of(map + "\"reliable\"\n").cut_off, 0.0);
  EXPECT_EQ(mistakes_of(shape_case(map + "0\n")),
            "  case.toml:6: surface.cut_off = 0, but must be > 0 [m]\n");
  const std::string mistake = mistakes_of(shape_case(map + "\"relible\"\n"));
  EXPECT_NE(mistake.find("; or it is \"reliable\""), std::string::npos)
      << mistake;
}

TEST(SurfaceKinds, FitAWholeNumberOfWaves) {
  EXPECT_EQ(mistakes_of(shape_case("kind = \"wave-1d\"\nlength = 1.0\n"
                                   "points = 8\namplitude = 1e-3\n"
                                   "wavelength = 0.4\n")),
            "  case.toml:7: surface.wavelength = 0.4, but surface.length must "
            "be a whole multiple of it, but is 2.5 times it\n");
}

TEST(SurfaceKinds, HaveAFormulaForTheoryOrNot) {
  const std::string shape =
      shape_case("kind = \"sphere\"\nradius = 1\nlength = 1\npoints = 8\n");
  const Case read =
      read_case_text(shape + "[theory]\ngamma = 0.4\n", "case.toml");

  EXPECT_EQ(
      std::get<mechanics::TheorySettings>(read.methods[0].settings).spectrum,
      mechanics::TheorySpectrum::surface);
  EXPECT_EQ(
      mistakes_of(shape + "[theory]\ngamma = 0.4\nspectrum = \"formula\"\n"),
      "  case.toml:14: theory.spectrum = \"formula\", but must be \"surface\": "
      "only the kinds self-affine and spectrum have a formula\n");
}

TEST(SurfaceKinds, NeedALengthForRelativeLengths) {
  EXPECT_EQ(mistakes_of("schema = 1\n[surface]\nkind = \"self-affine\"\n"
                        "rms_slope = 0.1\nhurst = 1\n"
                        "wavelength_long = \"1 length\"\n"
                        "wavelength_roll_off = 1e-6\n"
                        "wavelength_short = \"8 h\"\n"
                        "[material]\ncontact_modulus = 1e9\n"
                        "[load]\nnominal_pressure = 1e6\n"
                        "[theory]\ngamma = 0.4\n"),
            "  case.toml:6: surface.wavelength_long = \"1 length\", but this "
            "needs surface.length\n"
            "  case.toml:8: surface.wavelength_short = \"8 h\", but h needs "
            "surface.length and surface.points\n");
}

// A half-space has free boundaries if the surface or its own table states so;
// the table takes precedence.
TEST(FreeBoundaries, AreThoseOfTheSurfaceOrOfTheMethod) {
  const std::string sphere =
      "kind = \"sphere\"\nradius = 1\nlength = 1\npoints = 8\n";
  const auto is_free = [&](const std::string& edges,
                           const std::string& boundaries) {
    const Case read =
        read_case_text(shape_case(sphere + edges) + boundaries, "case.toml");
    return std::get<mechanics::HalfspaceSettings>(read.methods[0].settings)
        .has_free_boundaries;
  };
  EXPECT_FALSE(is_free("", ""));
  EXPECT_TRUE(is_free("edges = \"free\"\n", ""));
  EXPECT_TRUE(is_free("", "boundaries = \"free\"\n"));
  EXPECT_FALSE(is_free("edges = \"free\"\n", "boundaries = \"periodic\"\n"));
  EXPECT_EQ(surface_of(sphere).edges, mechanics::Edges::periodic);
  EXPECT_EQ(surface_of(sphere + "edges = \"free\"\n").edges,
            mechanics::Edges::free);
}

TEST(FreeBoundaries, RefuseWhatNeedsAPeriodicSurface) {
  const std::string sphere =
      "kind = \"sphere\"\nradius = 1\nlength = 1\npoints = 8\n";
  const std::string free = shape_case(sphere + "edges = \"free\"\n");
  const std::string start = "  case.toml:12: halfspace has free boundaries "
                            "(here or by surface.edges = "
                            "\"free\"), but ";
  const std::string end = "; boundaries = \"periodic\" allows it\n";
  EXPECT_EQ(mistakes_of(free), "");
  EXPECT_EQ(mistakes_of(free, {"material.poisson_ratio=0.3",
                               "report.stress_inside=true"}),
            start +
                "report.stress_inside computes the stress of a periodic "
                "block" +
                end);
  EXPECT_EQ(
      mistakes_of(free + "[report]\nfields = 0\n", {"load={mean_gap=[1e-9]}"}),
      start +
          "[load] prescribes mean gaps: please prescribe "
          "nominal_pressure" +
          end);
  EXPECT_EQ(
      mistakes_of(shape_case(sphere + "edges = \"mirror\"\n")),
      "  case.toml:7: surface.edges = \"mirror\", but only a measured map "
      "is continued in this way; allowed here: \"periodic\", \"free\"\n");
  EXPECT_EQ(mistakes_of(free + "thickness = \"1 length\"\n",
                        {"material.poisson_ratio=0.3"}),
            "  case.toml:13: halfspace.thickness = \"1 length\", but free "
            "boundaries need a half-space of infinite thickness; boundaries = "
            "\"periodic\" allows a slab\n");
}

// A word denotes the enumerator of its name: the order of the vocabulary is
// that of case.hpp.
TEST(SurfaceKinds, AreWordsInTheOrderOfTheEnumerations) {
  const auto word = [](const std::string& table, const std::string& key,
                       auto enumerator) {
    return vocabulary_key(vocabulary_table(table), key)
        .words.at(static_cast<std::size_t>(enumerator));
  };

  EXPECT_EQ(word("surface", "kind", mechanics::SurfaceKind::self_affine),
            "self-affine");
  EXPECT_EQ(word("surface", "kind", mechanics::SurfaceKind::spectrum),
            "spectrum");
  EXPECT_EQ(word("surface", "kind", mechanics::SurfaceKind::measured),
            "measured");
  EXPECT_EQ(word("surface", "kind", mechanics::SurfaceKind::sphere), "sphere");
  EXPECT_EQ(word("surface", "kind", mechanics::SurfaceKind::wave_1d),
            "wave-1d");
  EXPECT_EQ(word("surface", "kind", mechanics::SurfaceKind::wave_2d),
            "wave-2d");
  EXPECT_EQ(word("surface", "amplitudes", mechanics::Amplitudes::gaussian),
            "gaussian");
  EXPECT_EQ(word("surface", "level", mechanics::Levelling::plane), "plane");
  EXPECT_EQ(word("surface", "edges", mechanics::Edges::window), "window");
  EXPECT_EQ(word("surface", "edges", mechanics::Edges::free), "free");
  EXPECT_EQ(word("fem", "contact", mechanics::ContactLaw::penalty), "penalty");
  EXPECT_EQ(word("fem", "contact", mechanics::ContactLaw::hard), "hard");
  EXPECT_EQ(word("fem", "contact", mechanics::ContactLaw::augmented),
            "augmented");
  EXPECT_EQ(word("fem", "top", mechanics::FarBoundary::sliding), "sliding");
  EXPECT_EQ(word("fem", "element", mechanics::Element::q2), "Q2");
  EXPECT_EQ(word("fem", "solver", mechanics::FemSolver::automatic), "auto");
  EXPECT_EQ(word("fem", "solver", mechanics::FemSolver::condensed),
            "condensed");
  EXPECT_EQ(word("theory", "spectrum", mechanics::TheorySpectrum::surface),
            "surface");
}

} // namespace asperity::cases::surface_kinds_test
