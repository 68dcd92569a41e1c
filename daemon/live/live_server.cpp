#include "live/live_server.h"

#include <utility>

#include "live/parameter_list.h"
#include "web/bundle.h"

namespace tp100::live {
namespace {

std::optional<server::PageFile> page_file(std::string_view path) {
  const web::File* file = web::find(path);
  if (file == nullptr) return std::nullopt;
  return server::PageFile{file->mime, file->bytes, file->etag, file->encoding};
}

}  // namespace

std::unique_ptr<server::Server> make_server(const config::RunSetup& run,
                                            const messages::PublishClock& clock,
                                            LiveControls& controls, server::Listener listener) {
  const config::ServerSettings& settings = run.configuration.server;
  server::ServerSettings out;
  out.listen = settings.listen;
  out.access = {server::words(settings.hosts), server::words(settings.origins)};
  out.commands = settings.commands;
  out.max_clients = static_cast<std::size_t>(settings.max_clients);
  out.runs_folder = run.configuration.record.directory;
  out.page = page_file;
  out.listener = std::move(listener);
  return std::make_unique<server::Server>(std::move(out),
                                          messages::Messages(config::subject_of(run), clock),
                                          parameter_list(run.configuration, run.robot), controls);
}

}  // namespace tp100::live
