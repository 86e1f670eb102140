// Text as LaTeX source.
#include <map>

#include "isobench/reports/latex/latex.h"

namespace isobench {

namespace {

const std::map<std::string, std::string>& replacements() {
  static const std::map<std::string, std::string> all = {{"\\", "\\textbackslash{}"},
                                                         {"{", "\\{"},
                                                         {"}", "\\}"},
                                                         {"$", "\\$"},
                                                         {"&", "\\&"},
                                                         {"#", "\\#"},
                                                         {"%", "\\%"},
                                                         {"_", "\\_"},
                                                         {"^", "\\textasciicircum{}"},
                                                         {"~", "\\textasciitilde{}"},
                                                         {"|", "\\textbar{}"},
                                                         {"<", "\\textless{}"},
                                                         {">", "\\textgreater{}"},
                                                         {"\n", " "},
                                                         {"–", "--"},
                                                         {"…", "\\dots{}"},
                                                         {"−", "$-$"},
                                                         {"×", "$\\times$"},
                                                         {"·", "$\\cdot$"},
                                                         {"°", "$^\\circ$"},
                                                         {"⁻", "$^-$"},
                                                         {"¹", "$^1$"},
                                                         {"½", "$\\frac{1}{2}$"},
                                                         {"√", "$\\surd$"},
                                                         {"š", "\\v{s}"},
                                                         {"²", "$^2$"},
                                                         {"³", "$^3$"},
                                                         {"µ", "$\\mu$"},
                                                         {"§", "\\S{}"},
                                                         {"†", "$^\\dagger$"},
                                                         {"‡", "$^\\ddagger$"},
                                                         {"≥", "$\\ge$"},
                                                         {"≤", "$\\le$"},
                                                         {"∇", "$\\nabla$"},
                                                         {"⌈", "$\\lceil$"},
                                                         {"⌉", "$\\rceil$"},
                                                         {"ε", "$\\varepsilon$"},
                                                         {"δ", "$\\delta$"},
                                                         {"κ", "$\\kappa$"},
                                                         {"λ", "$\\lambda$"},
                                                         {"Δ", "$\\Delta$"},
                                                         {"α", "$\\alpha$"},
                                                         {"β", "$\\beta$"},
                                                         {"π", "$\\pi$"},
                                                         {"τ", "$\\tau$"},
                                                         {"χ", "$\\chi$"},
                                                         {"σ", "$\\sigma$"}};
  return all;
}

// Bytes of the UTF-8 character that starts here.
std::size_t character_length(unsigned char first) {
  if (first < 0xC0U) return 1;
  if (first < 0xE0U) return 2;
  return first < 0xF0U ? 3 : 4;
}

}  // namespace

std::string latex_escaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::string character = text.substr(i, character_length(static_cast<unsigned char>(text[i])));
    const auto found = replacements().find(character);
    result += found == replacements().end() ? character : found->second;
    i += character.size();
  }
  return result;
}

}  // namespace isobench
