// --set key=value on an experiment.
#include "isobench/experiments/plan/config.h"
#include "isobench/methods/method.h"

namespace isobench {

void set_parameter(Config& config, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) throw UsageError("--set " + setting + ": expected key=value");
  const std::string name = setting.substr(0, equals);
  std::vector<std::string> known;
  bool found = false;
  for (MethodEntry& entry : config.methods) {
    const ParameterSchema& schema = method(entry.name).parameters;
    for (const ParameterSpec& spec : schema) {
      known.push_back(spec.name);
      if (spec.name != name) continue;
      Parameters checked(schema);
      checked.set_text(schema, name, setting.substr(equals + 1));
      entry.parameters[name] = {checked.all().at(name)};
      found = true;
    }
  }
  if (!found) {
    throw UsageError("--set " + setting + ": no method of this experiment has a parameter '" + name + "'" +
                     suggestion(name, known));
  }
}

}  // namespace isobench
