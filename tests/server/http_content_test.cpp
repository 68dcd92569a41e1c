// What is served over HTTP, and nothing else of the disk.
#include "server/http_content.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "../support/temporary_folder.h"
#include "server/access.h"
#include "text/file_name.h"
#include "web/bundle.h"

namespace tp100::server {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::Pair;

constexpr unsigned char kHtml[] = "<html>";
constexpr web::File kPage = {"/", "text/html", "\"5a\"", {kHtml, 6}, {kHtml, 3}};

class HttpContent : public ::testing::Test {
 protected:
  HttpContent() {
    sources_.page = [](std::string_view path) { return path == "/" ? &kPage : nullptr; };
    sources_.runs_folder = folder_.file("runs");
    sources_.runs = [] { return std::string(R"({"runs":[]})"); };
    sources_.health = [] { return std::string("{}"); };
    fs::create_directories(folder_.file("runs/a"));
    fs::create_directories(folder_.file("runs/b"));
    test::write_bytes(folder_.file("runs/a/run.mcap"), "0123456789");
    test::write_bytes(folder_.file("runs/b/report.html"), "<p>");
    test::write_bytes(folder_.file("secret"), "secret");
  }

  HttpAnswer get(const std::string& target, const std::string& range = {},
                 const std::string& none_match = {}) const {
    return http_answer({"GET", target, range, none_match}, sources_);
  }

  test::TemporaryFolder folder_;
  HttpSources sources_;
};

TEST_F(HttpContent, ThePageIsServedOnceUntilItChanges) {
  const HttpAnswer first = get("/?x#y");
  EXPECT_EQ(first.status, 200U);
  EXPECT_EQ(first.length, 6U);
  EXPECT_THAT(first.headers, Contains(Pair("ETag", "\"5a\"")));
  EXPECT_EQ(get("/", {}, "\"5a\"").status, 304U);
  EXPECT_EQ(get("/", {}, "\"other\"").status, 200U);
}

// A slow link would take a minute for the page, and a program that knows no gzip could not read it.
TEST_F(HttpContent, WhoTakesGzipGetsIt) {
  sources_.history = [](std::string_view, double span_s) {
    return std::string(static_cast<std::size_t>(span_s) * 1000, '7');
  };
  const auto packed = [this](const std::string& target) {
    HttpRequest request{"GET", target, {}, {}};
    request.gzip = true;
    return http_answer(request, sources_);
  };
  EXPECT_EQ(packed("/").length, 3U);
  EXPECT_THAT(packed("/").headers, Contains(Pair("Content-Encoding", "gzip")));
  const HttpAnswer history = packed("/api/history/estimate?span_s=60");
  EXPECT_THAT(history.headers, Contains(Pair("Content-Encoding", "gzip")));
  test::write_bytes(folder_.file("history.gz"), history.body);
  const std::string unpack =
      "gzip -dc " + folder_.file("history.gz") + " > " + folder_.file("history");
  ASSERT_EQ(std::system(unpack.c_str()), 0);
  EXPECT_EQ(fs::file_size(folder_.file("history")), 60'000U);
  EXPECT_EQ(get("/api/history/estimate?span_s=60").body.size(), 60'000U);
  EXPECT_LT(packed("/api/history/estimate?span_s=1").body.size(), 1001U);
}

TEST_F(HttpContent, OnlyGetAndHeadAreServed) {
  EXPECT_EQ(http_answer({"HEAD", "/", {}, {}}, sources_).status, 200U);
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE"}) {
    const HttpAnswer answer = http_answer({method, "/", {}, {}}, sources_);
    EXPECT_EQ(answer.status, 405U);
    EXPECT_THAT(answer.headers, Contains(Pair("Allow", "GET, HEAD")));
  }
}

TEST_F(HttpContent, AFileIsInUseWhileItIsServed) {
  const int other = ::open(folder_.file("runs/a/run.mcap").c_str(), O_RDONLY | O_CLOEXEC);
  {
    const HttpAnswer answer = get("/runs/a/run.mcap");
    EXPECT_NE(::flock(other, LOCK_EX | LOCK_NB), 0);
  }
  EXPECT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
  ::close(other);
}

TEST_F(HttpContent, TheListOfRunsIsServedAndAnAbsentFolderHasNone) {
  const HttpAnswer list = get("/api/runs?x");
  EXPECT_EQ(list.body, R"({"runs":[]})");
  EXPECT_EQ(list.type, "application/json");
  sources_.runs = {};
  EXPECT_EQ(get("/api/runs").status, 404U);
  for (const std::string& folder : {std::string(), folder_.file("none")}) {
    sources_.runs_folder = folder;
    EXPECT_EQ(get("/runs/a/run.mcap").status, 404U);
  }
}

TEST_F(HttpContent, NothingOutsideOfARunIsServed) {
  fs::create_symlink(folder_.path() / "secret", folder_.path() / "runs/a/link.csv");
  fs::create_directory_symlink(folder_.path(), folder_.path() / "runs/linked");
  ASSERT_EQ(mkfifo((folder_.path() / "runs/a/pipe.csv").c_str(), 0600), 0);
  for (const std::string& target :
       words("/runs/ /runs/a /runs/a/ /runs/../secret /runs/a/../../secret /runs/a/.. "
             "/runs/./a/run.mcap /runs/a/link.csv /runs/linked/secret /runs/a/pipe.csv "
             "/runs//etc/passwd /runs/a/%2e%2e /runs/a/b/run.mcap /secret //secret x "
             "/runs/a/run.mcap% /runs/%zz/run.mcap /runs/a%2F..%2Fb/run.mcap "
             "/runs/a%2F%2E%2E/b/run.mcap /runs/%2E%2E/secret /runs/a/%00 /runs/a%5Cb/run.mcap "
             "/runs/%2e%2e%2fsecret /runs/a%252Fb.zip /runs/none.zip /runs/.zip /runs/...zip "
             "/runs/../a.zip"))
    EXPECT_EQ(get(target).status, 404U) << target;
  EXPECT_EQ(get("").status, 404U);
}

TEST_F(HttpContent, PartsOfAFileAreServedForScrubbing) {
  const auto part = [&](const char* range) {
    const HttpAnswer answer = get("/runs/a/run.mcap", range);
    return std::tuple(answer.status, answer.offset, answer.length);
  };
  for (const auto& [range, offset, length] :
       {std::tuple("bytes=2-4", 2U, 3U), std::tuple("bytes=7-", 7U, 3U),
        std::tuple("bytes=7-100", 7U, 3U), std::tuple("bytes=-4", 6U, 4U),
        std::tuple("bytes=-40", 0U, 10U)})
    EXPECT_EQ(part(range), std::tuple(206U, offset, length)) << range;
  for (const char* whole : {"", "bytes=", "bytes=-", "bytes=4-2", "bytes=1-2,4-5", "lines=1-2",
                            "bytes=a-b", "bytes=99999999999999999999-"})
    EXPECT_EQ(part(whole), std::tuple(200U, 0U, 10U)) << whole;
  for (const char* outside : {"bytes=10-", "bytes=10-20", "bytes=-0"}) {
    const HttpAnswer answer = get("/runs/a/run.mcap", outside);
    EXPECT_EQ(answer.status, 416U) << outside;
    EXPECT_THAT(answer.headers, Contains(Pair("Content-Range", "bytes */10")));
  }
}

TEST_F(HttpContent, AWholeRunIsServedAsOneArchive) {
  HttpAnswer answer = get("/runs/a.zip");
  EXPECT_EQ(answer.status, 200U);
  EXPECT_EQ(answer.type, "application/zip");
  EXPECT_THAT(answer.headers,
              Contains(Pair("Content-Disposition",
                            "attachment; filename=\"a.zip\"; filename*=UTF-8''a.zip")));
  std::string all, part(65'536, '\0');
  while (answer.length > 0) all.append(part, 0, answer.read(part).value());
  EXPECT_EQ(all.substr(0, 4), "PK\3\4");
  EXPECT_NE(all.find("a/run.mcap0123456789"), std::string::npos);
}

// A run that was recorded on a course of a person's own naming would be invisible.
TEST_F(HttpContent, ARunOfAnyNameIsServedByItsAddress) {
  const std::string runs = (folder_.path() / "runs").string();
  for (const char* name :
       {"slalom (copy)", "Prüf strecke", "a&b=c", "道路", "a'b\"c", "<script>", "a+b;c"}) {
    fs::create_directory(runs + "/" + name);
    test::write_bytes(runs + "/" + name + "/run.mcap", "0123456789");
    const std::string address = "/runs/" + text::percent_encoded(name);
    EXPECT_EQ(get((address + "/run.mcap").c_str()).length, 10U) << name;
    // As browsers and people write it.
    EXPECT_EQ(get(("/runs/" + std::string(name) + "/run.mcap").c_str()).length, 10U) << name;
    const HttpAnswer zip = get((address + ".zip").c_str());
    EXPECT_EQ(zip.status, 200U) << name;
    for (const auto& [header, value] : zip.headers)
      EXPECT_TRUE(std::ranges::all_of(value, [](char c) { return c >= ' ' && c <= '~'; }))
          << header << ": " << value;
    EXPECT_TRUE(needs_disk(address + ".zip"));
  }
}

// The server's thread, which serves STOP, would wait for the disk.
TEST_F(HttpContent, OnlyRunsAndTheirFilesNeedTheDiskAlsoUnderAnAddressInDisguise) {
  for (const char* target :
       {"/api/runs", "/api/runs?x", "/runs/", "/runs/a/run.mcap", "/%72uns/a/run.mcap",
        "/runs%2fa%2frun.mcap", "/api/%72uns", "/api%2Fsetup", "/%63ourses/a.toml?x"})
    EXPECT_TRUE(needs_disk(target)) << target;
  for (const char* target : {"/", "/healthz", "/app.js", "", "/none", "/%", "/%zz/runs/"})
    EXPECT_FALSE(needs_disk(target)) << target;
}

TEST_F(HttpContent, AReportIsKeptAwayFromTheServer) {
  const HttpAnswer report = get("/runs/b/report.html");
  EXPECT_EQ(report.type, "text/html; charset=utf-8");
  EXPECT_THAT(report.headers,
              Contains(Pair("Content-Security-Policy", ::testing::HasSubstr("sandbox"))));
}

}  // namespace
}  // namespace tp100::server
