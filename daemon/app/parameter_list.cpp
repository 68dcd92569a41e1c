#include "app/parameter_list.h"

#include <utility>

#include "course/robot_keys.h"

namespace tp100::app {
namespace {

using publish::ParameterText;

ParameterText::Type type_of(course::KeyText::Type type) {
  switch (type) {
    case course::KeyText::Type::kNumber:
      return ParameterText::Type::kNumber;
    case course::KeyText::Type::kInteger:
      return ParameterText::Type::kInteger;
    case course::KeyText::Type::kBoolean:
      return ParameterText::Type::kBoolean;
    case course::KeyText::Type::kText:
      return ParameterText::Type::kText;
    case course::KeyText::Type::kChoice:
      break;
  }
  return ParameterText::Type::kChoice;
}

}  // namespace

std::vector<ParameterText> parameter_list(const Configuration& configuration,
                                          const course::Robot& robot) {
  std::vector<course::KeyText> keys = configuration_keys(configuration);
  for (course::KeyText& key : course::robot_keys(robot)) keys.push_back(std::move(key));
  std::vector<ParameterText> out;
  for (course::KeyText& key : keys) {
    ParameterText text;
    text.name = std::move(key.name);
    text.type = type_of(key.type);
    text.value = std::move(key.value);
    text.standard = std::move(key.standard);
    text.unit = std::move(key.unit);
    text.min = key.range.min;
    text.max = key.range.max;
    text.choices = std::move(key.choices);
    text.meaning = std::move(key.meaning);
    out.push_back(std::move(text));
  }
  return out;
}

}  // namespace tp100::app
