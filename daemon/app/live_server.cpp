#include "app/live_server.h"

#include <utility>

#include "app/parameter_list.h"
#include "web/bundle.h"

namespace tp100::app {
namespace {

std::optional<publish::PageFile> page_file(std::string_view path) {
  const web::File* file = web::find(path);
  if (file == nullptr) return std::nullopt;
  return publish::PageFile{file->mime, file->bytes, file->etag, file->encoding};
}

}  // namespace

std::unique_ptr<publish::Server> make_server(const RunSetup& run,
                                             const publish::PublishClock& clock,
                                             LiveControls& controls, publish::Listener listener) {
  const ServerSettings& settings = run.configuration.server;
  publish::ServerSettings out;
  out.listen = settings.listen;
  out.access = {publish::words(settings.hosts), publish::words(settings.origins)};
  out.commands = settings.commands;
  out.max_clients = static_cast<std::size_t>(settings.max_clients);
  out.runs_folder = run.configuration.record.directory;
  out.page = page_file;
  out.listener = std::move(listener);
  return std::make_unique<publish::Server>(std::move(out),
                                           publish::Messages(subject_of(run), clock),
                                           parameter_list(run.configuration, run.robot), controls);
}

}  // namespace tp100::app
