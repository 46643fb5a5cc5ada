#include "input/expression.hpp"

#include <muParser.h>
#include <numbers>
#include <stdexcept>

namespace asperity::input {

/// The parser and the variables to which it is bound.
struct Expression::Bound {
  double value() {
    try {
      return parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
      throw std::domain_error(error.GetMsg() + " (column " +
                              std::to_string(error.GetPos() + 1) + ")");
    }
  }

  std::array<double, 3> place{};
  mu::Parser parser;
};

Expression::Expression(const std::string& text)
    : bound_(std::make_shared<Bound>()) {
  bound_->parser.DefineConst("pi", std::numbers::pi);
  bound_->parser.DefineVar("x", &bound_->place[0]);
  bound_->parser.DefineVar("y", &bound_->place[1]);
  bound_->parser.DefineVar("z", &bound_->place[2]);
  try {
    bound_->parser.SetExpr(text);
  } catch (const mu::Parser::exception_type& error) { // invalid character
    throw std::domain_error(error.GetMsg());
  }
  bound_->value(); // evaluate once, because muParser parses on evaluation
}

double Expression::at(const std::array<double, 3>& place) const {
  bound_->place = place;
  return bound_->value();
}

} // namespace asperity::input
