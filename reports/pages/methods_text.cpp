#include "reports/pages/methods_text.hpp"

#include "input/reader/resolved_keys.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/pages/html_report.hpp"
#include "reports/study_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace asperity::reports {
namespace {

struct Source {
  const char* key;
  const char* entry; // BibTeX behind the key
};

constexpr std::array sources{
    Source{"yang2008", R"(@article{yang2008,
  author = {Yang, C. and Persson, B. N. J.},
  title = {Contact mechanics: contact area and interfacial separation from small contact to full contact},
  journal = {J. Phys.: Condens. Matter}, volume = {20}, pages = {215214}, year = {2008},
  doi = {10.1088/0953-8984/20/21/215214}
})"},
    Source{"persson2001", R"(@article{persson2001,
  author = {Persson, B. N. J.},
  title = {Theory of rubber friction and contact mechanics},
  journal = {J. Chem. Phys.}, volume = {115}, pages = {3840--3861}, year = {2001},
  doi = {10.1063/1.1388626}
})"},
    Source{"persson2002", R"(@article{persson2002,
  author = {Persson, B. N. J.},
  title = {Adhesion between an elastic body and a randomly rough hard surface},
  journal = {Eur. Phys. J. E}, volume = {8}, pages = {385--401}, year = {2002},
  doi = {10.1140/epje/i2002-10025-1}
})"},
    Source{"ciavarella1998", R"(@article{ciavarella1998,
  author = {Ciavarella, M.},
  title = {Tangential loading of general three-dimensional contacts},
  journal = {J. Appl. Mech.}, volume = {65}, pages = {998--1003}, year = {1998}
})"},
    Source{"barber2003", R"(@article{barber2003,
  author = {Barber, J. R.},
  title = {Bounds on the electrical resistance between contacting elastic rough bodies},
  journal = {Proc. R. Soc. Lond. A}, volume = {459}, pages = {53--66}, year = {2003},
  doi = {10.1098/rspa.2002.1038}
})"},
    Source{"polonsky1999", R"(@article{polonsky1999,
  author = {Polonsky, I. A. and Keer, L. M.},
  title = {A numerical method for solving rough contact problems based on the multi-level multi-summation and conjugate gradient techniques},
  journal = {Wear}, volume = {231}, pages = {206--219}, year = {1999},
  doi = {10.1016/S0043-1648(99)00113-1}
})"},
    Source{"yastrebov2017", R"(@article{yastrebov2017,
  author = {Yastrebov, V. A. and Anciaux, G. and Molinari, J.-F.},
  title = {On the accurate computation of the true contact-area in mechanical contact of random rough surfaces},
  journal = {Tribol. Int.}, volume = {114}, pages = {161--171}, year = {2017},
  doi = {10.1016/j.triboint.2017.04.023},
  eprint = {1701.02727}, archiveprefix = {arXiv}
})"},
    Source{"yang2006", R"(@article{yang2006,
  author = {Yang, C. and Tartaglino, U. and Persson, B. N. J.},
  title = {A multiscale molecular dynamics approach to contact mechanics},
  journal = {Eur. Phys. J. E}, volume = {19}, pages = {47--58}, year = {2006},
  doi = {10.1140/epje/e2006-00004-9}
})"},
    Source{"johnson1985", R"(@book{johnson1985,
  author = {Johnson, K. L.},
  title = {Contact Mechanics},
  publisher = {Cambridge University Press}, year = {1985},
  doi = {10.1017/CBO9781139171731}
})"},
    Source{"frigo2005", R"(@article{frigo2005,
  author = {Frigo, M. and Johnson, S. G.},
  title = {The Design and Implementation of {FFTW3}},
  journal = {Proc. IEEE}, volume = {93}, number = {2}, pages = {216--231}, year = {2005},
  doi = {10.1109/JPROC.2004.840301}
})"},
    Source{"arndt2021", R"(@article{arndt2021,
  author = {Arndt, D. and Bangerth, W. and Davydov, D. and Heister, T. and Heltai, L. and Kronbichler, M. and Maier, M. and Pelteret, J.-P. and Turcksin, B. and Wells, D.},
  title = {The {deal.II} finite element library: Design, features, and insights},
  journal = {Comput. Math. Appl.}, volume = {81}, pages = {407--422}, year = {2021},
  doi = {10.1016/j.camwa.2020.02.022}
})"},
    Source{"thompson2022", R"(@article{thompson2022,
  author = {Thompson, A. P. and Aktulga, H. M. and Berger, R. and Bolintineanu, D. S. and Brown, W. M. and Crozier, P. S. and {in 't Veld}, P. J. and Kohlmeyer, A. and Moore, S. G. and Nguyen, T. D. and Shan, R. and Stevens, M. J. and Tranchida, J. and Trott, C. and Plimpton, S. J.},
  title = {{LAMMPS} - a flexible simulation tool for particle-based materials modeling at the atomic, meso, and continuum scales},
  journal = {Comput. Phys. Commun.}, volume = {271}, pages = {108171}, year = {2022},
  doi = {10.1016/j.cpc.2021.108171}
})"}};

std::string fact(const ReportEntry& entry, std::string_view key) {
  for (const auto& [name, value] : entry.summary.provenance)
    if (name == key)
      return value;
  return "";
}

bool has_kind(const ReportEntry& entry, std::string_view kind) {
  return std::ranges::any_of(entry.result->methods, [&](const auto& method) {
    return method.kind == kind;
  });
}

/// True if one of the methods runs LAMMPS.
bool uses_lammps(const ReportEntry& entry) {
  return std::ranges::any_of(
      entry.contact_case->methods, [](const cases::MethodSpec& method) {
        const auto* const atoms =
            std::get_if<mechanics::MdSettings>(&method.settings);
        return atoms != nullptr &&
               atoms->engine == mechanics::AtomEngine::lammps;
      });
}

/// Returns a version in blanks, " 9.4.1"; "" if it is not known.
std::string version(std::string text) {
  if (const std::size_t at = text.find_first_of("0123456789");
      at != std::string::npos)
    text.erase(0, at);
  text = text.substr(0, text.find_first_of(" ,-"));
  return text.empty() ? "" : " " + text;
}

/// "a finite slab and a half-space": what the methods of this kind press.
std::string continuum_words(const ReportEntry& entry) {
  bool has_slab = false;
  bool has_infinite = false;
  for (const cases::MethodSpec& method : entry.contact_case->methods)
    if (const auto* const halfspace =
            std::get_if<mechanics::HalfspaceSettings>(&method.settings))
      (halfspace->block().is_infinite() ? has_infinite : has_slab) = true;
  return !has_slab      ? "half-space"
         : has_infinite ? "half-space, and a slab of finite thickness,"
                        : "slab of finite thickness";
}

std::string continuum_sentences(const ReportEntry& entry) {
  const bool has_halfspace = has_kind(entry, "halfspace");
  const bool has_fem = has_kind(entry, "fem");
  std::string text;
  if (has_halfspace)
    text +=
        fmt::format(" The continuum {} was treated in Fourier space (FFTW{} "
                    "[frigo2005]).",
                    continuum_words(entry), version(fact(entry, "FFTW")));
  if (has_fem)
    text += fmt::format(
        " The finite-element block was discretised with deal.II{} "
        "[arndt2021]{}.",
        version(fact(entry, "deal.II")),
        has_halfspace ? "" : ", with Fourier transforms by FFTW [frigo2005]");
  if (has_halfspace || has_fem)
    text +=
        " The contact problem was solved by a preconditioned variant of the "
        "conjugate gradients of [polonsky1999]. Contact areas were corrected "
        "for the grid by the place of the contact edge between the nodes, by "
        "the contact perimeter, which is counted as in [yastrebov2017], and by "
        "the number of contact patches and holes.";
  return text;
}

/// What each method is, as its result describes it.
std::string method_sentences(const ReportEntry& entry) {
  std::string text;
  for (const results::MethodRecord& method : entry.result->methods)
    text += fmt::format("{} {}: {}", text.empty() ? " Methods:" : ";",
                        method.name, method.description);
  return text.empty() ? "" : text + ".";
}

std::string study_sentences(const cases::Case& contact_case) {
  std::string text;
  for (const StudyPages* const study : study_pages())
    if (study->methods_text != nullptr)
      text += study->methods_text(contact_case);
  return text;
}

/// Whether a key has an influence on what is computed.
bool is_physical(const std::string& path) {
  constexpr std::array<std::string_view, 4> others{"report.", "expect.",
                                                   "sweep.", "schema"};
  return path.find('.') != std::string::npos &&
         std::ranges::none_of(others, [&](std::string_view other) {
           return path.starts_with(other);
         });
}

/// The keys that the case gives, as it writes them; of a file, its name.
std::string settings_of(const ReportEntry& entry) {
  std::string text;
  for (const cases::ResolvedKey& key :
       cases::resolved_keys(*entry.contact_case, {}))
    if (!key.written.empty() && is_physical(key.path)) {
      const std::size_t folder = key.path.ends_with("file")
                                     ? key.written.rfind('/')
                                     : std::string::npos;
      text += fmt::format("{}{} = {}", text.empty() ? "" : "; ", key.path,
                          folder == std::string::npos
                              ? key.written
                              : "\"" + key.written.substr(folder + 1));
    }
  return text;
}

std::string paragraph_on(const ReportEntry& entry) {
  if (has_kind(entry, measured_kind))
    return entry.summary.case_name + ": " +
           entry.result->methods.front().description + ".";
  const std::string program = fact(entry, "program");
  const std::string commit = fact(entry, "commit");
  std::string text =
      program.empty()
          ? "The results were evaluated with Asperity."
          : fmt::format("The contact was computed with Asperity{}{}.",
                        version(program),
                        commit.empty() ? "" : " (commit " + commit + ")");
  text += " " + setup_sentences(entry);
  if (has_kind(entry, "theory"))
    text += " Persson's theory [persson2001] was evaluated for contact area "
            "and interfacial separation as in [yang2008].";
  text += method_sentences(entry);
  text += continuum_sentences(entry);
  if (has_kind(entry, "md"))
    text += " The atomistic block and its interaction with the substrate "
            "follow [yang2006] and [yang2008].";
  if (uses_lammps(entry))
    text += " Atoms were moved by LAMMPS [thompson2022].";
  if (has_kind(entry, "winkler"))
    text += " The Winkler foundation consists of independent springs "
            "[johnson1985].";
  if (is_exact_shape(*entry.contact_case))
    text += " The exact solutions are given in [johnson1985].";
  text += study_sentences(*entry.contact_case);
  if (entry.result->case_text.empty())
    return text;
  return text + fmt::format(" The case file has the hash {}. It sets {}; all "
                            "other keys have their default values.",
                            entry.summary.case_hash.substr(0, 12),
                            settings_of(entry));
}

} // namespace

MethodsText methods_text(std::span<const ReportEntry> entries) {
  MethodsText text;
  std::string all;
  for (const ReportEntry& entry : entries) {
    text.paragraphs.push_back(paragraph_on(entry));
    all += text.paragraphs.back();
  }
  for (const Source& source : sources)
    if (all.find(fmt::format("[{}]", source.key)) != std::string::npos)
      text.literature += std::string(source.entry) + "\n\n";
  return text;
}

} // namespace asperity::reports
