#include "isobench/methods/parameters.h"

#include <gtest/gtest.h>

#include <functional>

namespace isobench {
namespace {

const ParameterSchema& schema() {
  static const ParameterSchema declared{
      {.name = "sweeps", .default_value = 50.0, .unit = "", .description = "", .min = 0, .max = 1000, .integer = true},
      {.name = "radius", .default_value = 1.5, .unit = "mm", .description = "", .min = 0},
      {.name = "ceiling", .default_value = -1.0, .unit = "", .description = "", .max = 0},
      {.name = "offset", .default_value = 0.1, .unit = "mm", .description = ""},
      {.name = "finish", .default_value = true, .unit = "", .description = ""},
      {.name = "seeds",
       .default_value = std::string("uniform"),
       .unit = "",
       .description = "",
       .choices = {"uniform", "elimination"}},
      {.name = "note", .default_value = std::string(), .unit = "", .description = ""}};
  return declared;
}

std::string usage_error(const std::function<void()>& action) {
  try {
    action();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

std::string error_of(const std::string& name, const ParameterValue& value) {
  return usage_error([&] { Parameters(schema()).set(schema(), name, value, {"a.toml", 3, 4}); });
}

std::string error_of_text(const std::string& name, const std::string& text) {
  return usage_error([&] { Parameters(schema()).set_text(schema(), name, text); });
}

TEST(Parameters, StartAtTheirDefaultsAndAreComplete) {
  const Parameters parameters(schema());
  EXPECT_EQ(parameters.all().size(), schema().size());
  EXPECT_EQ(parameters.integer("sweeps"), 50);
  EXPECT_EQ(parameters.number("radius"), 1.5);
  EXPECT_TRUE(parameters.flag("finish"));
  EXPECT_EQ(parameters.text("seeds"), "uniform");
}

TEST(Parameters, TakeValuesWithinTheBoundsThemselves) {
  Parameters parameters(schema());
  parameters.set(schema(), "sweeps", 1000.0);
  parameters.set(schema(), "radius", 0.0);
  parameters.set(schema(), "finish", false);
  parameters.set(schema(), "seeds", std::string("elimination"));
  EXPECT_EQ(parameters.integer("sweeps"), 1000);
  EXPECT_EQ(parameters.number("radius"), 0.0);
  EXPECT_FALSE(parameters.flag("finish"));
  EXPECT_EQ(parameters.text("seeds"), "elimination");
}

TEST(Parameters, TakeTextByTheDeclaredType) {
  Parameters parameters(schema());
  parameters.set_text(schema(), "sweeps", "7");
  parameters.set_text(schema(), "radius", "2.5e-1");
  parameters.set_text(schema(), "finish", "false");
  parameters.set_text(schema(), "note", "12");
  EXPECT_EQ(parameters.integer("sweeps"), 7);
  EXPECT_EQ(parameters.number("radius"), 0.25);
  EXPECT_FALSE(parameters.flag("finish"));
  EXPECT_EQ(parameters.text("note"), "12");
}

TEST(ParameterErrors, AnUnknownNameComesWithTheNearest) {
  EXPECT_EQ(error_of("raduis", 1.0), "a.toml:3:4: unknown parameter 'raduis'; did you mean 'radius'?");
  EXPECT_EQ(usage_error([] { Parameters().set({}, "x", 1.0); }), "unknown parameter 'x'; the method has none");
}

TEST(ParameterErrors, ValuesOutOfRangeAreToldTheRange) {
  EXPECT_EQ(error_of("sweeps", -1.0), "a.toml:3:4: 'sweeps' must be an integer from 0 to 1000, not -1");
  EXPECT_EQ(error_of("sweeps", 2.5), "a.toml:3:4: 'sweeps' must be an integer from 0 to 1000, not 2.5");
  EXPECT_EQ(error_of("radius", -0.5), "a.toml:3:4: 'radius' must be a number of at least 0 mm, not -0.5");
  EXPECT_EQ(error_of("ceiling", 0.5), "a.toml:3:4: 'ceiling' must be a number of at most 0, not 0.5");
}

TEST(ParameterErrors, NumbersMustBeFinite) {
  EXPECT_EQ(error_of("offset", std::numeric_limits<double>::quiet_NaN()),
            "a.toml:3:4: 'offset' must be a finite number, not nan");
  EXPECT_EQ(error_of_text("offset", "inf"), "'offset' must be a finite number, not inf");
}

TEST(ParameterErrors, WrongTypesAreToldTheRightOne) {
  EXPECT_EQ(error_of("radius", std::string("wide")), "a.toml:3:4: 'radius' must be a number, not wide");
  EXPECT_EQ(error_of("radius", true), "a.toml:3:4: 'radius' must be a number, not true");
  EXPECT_EQ(error_of("finish", 1.0), "a.toml:3:4: 'finish' must be true or false, not 1");
  EXPECT_EQ(error_of("seeds", 1.0), "a.toml:3:4: 'seeds' must be a string, not 1");
  EXPECT_EQ(error_of_text("radius", "1.5mm"), "'radius' must be a number, not 1.5mm");
  EXPECT_EQ(error_of_text("finish", "yes"), "'finish' must be true or false, not yes");
}

TEST(ParameterErrors, ChoicesAreNamed) {
  EXPECT_EQ(error_of("seeds", std::string("elimnation")),
            "a.toml:3:4: 'seeds' cannot be 'elimnation'; did you mean 'elimination'?");
}

TEST(ParameterErrors, ARefusedValueChangesNothing) {
  Parameters parameters(schema());
  EXPECT_THROW(parameters.set(schema(), "radius", -1.0), UsageError);
  EXPECT_EQ(parameters.number("radius"), 1.5);
}

TEST(ParameterErrors, ADefaultOutsideItsOwnRangeIsFound) {
  const ParameterSchema wrong{{.name = "n", .default_value = 5.0, .unit = "", .description = "", .max = 1}};
  EXPECT_THROW(Parameters{wrong}, UsageError);
}

TEST(ParameterErrors, AskingForWhatWasNotDeclaredIsALogicError) {
  const Parameters parameters(schema());
  EXPECT_THROW(parameters.number("width"), std::logic_error);
  EXPECT_THROW(parameters.number("finish"), std::logic_error);
  EXPECT_THROW(parameters.integer("radius"), std::logic_error);
}

TEST(ParameterValues, PrintSoThatTheyReadBackTheSame) {
  EXPECT_EQ(to_string(ParameterValue(true)), "true");
  EXPECT_EQ(to_string(ParameterValue(3.0)), "3");
  EXPECT_EQ(std::stod(to_string(ParameterValue(0.1))), 0.1);
  EXPECT_EQ(std::stod(to_string(ParameterValue(1.0 / 3.0))), 1.0 / 3.0);
  EXPECT_EQ(to_string(ParameterValue(std::string("a b"))), "a b");
}

TEST(Parameters, MinusZeroIsZero) {
  const ParameterSchema schema = {{"n", 1.0, "", "a number", -1.0, 1.0, {}, false}};
  Parameters parameters(schema);
  parameters.set_text(schema, "n", "-0");
  EXPECT_EQ(to_string(parameters.all().at("n")), "0");
}

}  // namespace
}  // namespace isobench
