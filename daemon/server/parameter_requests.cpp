#include "server/parameter_requests.h"

#include <algorithm>
#include <array>
#include <utility>

#include "server/service.h"
#include "text/json_writer.h"

namespace tp100::server {
namespace {

constexpr HostNs kOverdueNs = 500 * kNsPerMs;
constexpr std::size_t kChangeBytes = 4096;  // what every viewer is told of a change
constexpr const char* kSteering = "estimation.steering";

}  // namespace

ParameterRequests::ParameterRequests(Broker& broker, Publisher& publisher, Controls& controls,
                                     std::vector<messages::ParameterText> parameters)
    : broker_(broker),
      publisher_(publisher),
      controls_(controls),
      parameters_(std::move(parameters)) {
  publish(publisher_.clock().start_ns);
}

void ParameterRequests::publish(HostNs now) {
  broker_.publish(messages::Channel::kParameter, publisher_.clock().unix_ns(now),
                  messages::parameters_message(parameters_));
}

bool ParameterRequests::under_way() const { return tp100::under_way(publisher_.state().run); }

void ParameterRequests::change_setup(std::vector<messages::ParameterText> parameters, HostNs now) {
  for (messages::ParameterText& next : parameters) {
    const auto old = std::ranges::find(parameters_, next.name, &messages::ParameterText::name);
    if (next.live && old != parameters_.end()) next.value = old->value;
  }
  parameters_ = std::move(parameters);
  publish(now);
}

std::vector<const messages::ParameterText*> ParameterRequests::select(
    const std::vector<std::string>& names) const {
  const std::set<std::string_view> wanted(names.begin(), names.end());
  std::vector<const messages::ParameterText*> out;
  for (const messages::ParameterText& parameter : parameters_)
    if (wanted.empty() || wanted.contains(parameter.name)) out.push_back(&parameter);
  return out;
}

void ParameterRequests::get(Viewer& viewer, const GetParameters& wanted) const {
  viewer.reply(parameter_values(select(wanted.names), wanted.id));
}

void ParameterRequests::watch(Viewer& viewer, const ParameterSubscription& wanted) {
  // Keeps existing names only, so that a client cannot make this grow.
  std::set<std::string>& names = watched_[viewer.id()];
  for (const messages::ParameterText* parameter : select(wanted.names)) {
    if (wanted.watch) {
      names.insert(parameter->name);
    } else {
      names.erase(parameter->name);
    }
  }
}

Result<> ParameterRequests::set_one(const SetParameters::One& one) {
  const auto found = std::ranges::find(parameters_, one.name, &messages::ParameterText::name);
  if (found == parameters_.end()) return no_such("parameter", one.name);
  if (!found->live)
    return Refusal{found->name + " cannot be changed while the daemon runs; set it in the file"};
  if (!one.value) return Refusal{found->name + " takes no value of that type"};
  if (found->only_at_standstill && under_way())
    return Refusal{found->name + " cannot be changed during a run"};
  if (std::string why = messages::why_not(*found, *one.value); !why.empty()) return Refusal{why};
  Result<> done = controls_.set(*found, *one.value);
  if (done) found->value = *one.value;
  return done;
}

void ParameterRequests::set(Viewer& viewer, const SetParameters& wanted, bool may_command,
                            HostNs now) {
  std::vector<std::string> names;
  bool changed = false;
  for (const SetParameters::One& one : wanted.parameters) {
    names.push_back(one.name);
    const Result<> done =
        may_command ? set_one(one)
                    : Refusal{"parameters are not taken from this client (server.commands)"};
    if (!done) {
      viewer.say(StatusLevel::kError, done.why());
      continue;
    }
    overdue_ns_ = now + kOverdueNs;
    viewer.charge(kChangeBytes);
    for (const messages::ParameterText* parameter : select({one.name}))
      parameter_changed(*parameter, now);
    changed = true;
  }
  if (changed) publish(now);
  if (!names.empty()) viewer.reply(parameter_values(select(names), wanted.id));
}

void ParameterRequests::parameter_changed(const messages::ParameterText& parameter, HostNs now) {
  std::string value;
  std::visit([&](const auto& content) { text::JsonWriter(value).value(content); }, parameter.value);
  publisher_.take(
      messages::Event{.at_ns = now, .kind = "parameter", .text = parameter.name + " = " + value});
  const std::array<const messages::ParameterText*, 1> changed = {&parameter};
  const std::string message = parameter_values(changed, "");
  for (const auto& viewer : broker_.viewers()) {
    const auto watched = watched_.find(viewer->id());
    if (watched != watched_.end() && watched->second.contains(parameter.name))
      viewer->reply(message);
  }
}

// The step may have ignored a change of the steering pose, because a run began before it.
void ParameterRequests::finish_overdue(HostNs now) {
  if (now < overdue_ns_) return;
  for (messages::ParameterText& parameter : parameters_) {
    if (parameter.name != kSteering || publisher_.last_step_ns() == 0) continue;
    const messages::ParameterValue used = std::string(to_string(publisher_.state().steering));
    if (parameter.value == used) continue;
    parameter.value = used;
    publish(now);
    parameter_changed(parameter, now);
  }
}

}  // namespace tp100::server
