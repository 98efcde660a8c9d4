// SPDX-License-Identifier: LGPL-2.1-or-later
#include "page_file.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <system_error>
#ifdef HAVE_OPENSSL
#include <openssl/evp.h>

#include <memory>
#endif

#ifndef SWEPT_VERSION
#define SWEPT_VERSION "of unknown version"
#endif

namespace swept::cli {
namespace {

std::ifstream opened(const std::string& path) {
  std::ifstream stream(pathFromUtf8(path), std::ios::binary);
  if (!stream)
    throw Error(
        Status::InvalidInput, "BadFile",
        "'" + path + "' cannot be opened for reading: " + std::system_category().message(errno));
  return stream;
}

#ifdef HAVE_OPENSSL
std::string sha256Of(const std::string& path) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(),
                                                                        &EVP_MD_CTX_free);
  if (!context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1) return {};
  std::ifstream stream = opened(path);
  std::vector<char> block(1 << 20);
  while (stream) {
    stream.read(block.data(), std::streamsize(block.size()));
    const auto count = static_cast<std::size_t>(stream.gcount());
    if (EVP_DigestUpdate(context.get(), block.data(), count) != 1) return {};
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (EVP_DigestFinal_ex(context.get(), digest.data(), &size) != 1) return {};
  std::string text;
  for (unsigned i = 0; i < size; ++i)
    for (const unsigned digit : {unsigned(digest[i]) >> 4, unsigned(digest[i]) & 15u})
      text += "0123456789abcdef"[digit];
  return text;
}
#else
std::string sha256Of(const std::string&) { return {}; }
#endif

std::string dateText() {
  std::time_t now = std::time(nullptr);
  if (const char* given = std::getenv("SOURCE_DATE_EPOCH"); given && *given) {
    char* end = nullptr;
    errno = 0;
    const long long value = std::strtoll(given, &end, 10);
    if (*end != '\0' || errno != 0)
      throw Error(
          Status::InvalidInput, "BadOption",
          std::string("the environment variable SOURCE_DATE_EPOCH is '") + given +
              "', but must be a whole number of seconds since 1970-01-01; correct or unset it");
    now = static_cast<std::time_t>(value);
  }
  const std::tm* parts = std::gmtime(&now);
  std::array<char, 40> text{};
  if (!parts || std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", parts) == 0)
    throw Error(Status::InvalidInput, "BadOption",
                "the environment variable SOURCE_DATE_EPOCH is too large to be a date on this "
                "system; use a smaller number, or unset it");
  return text.data();
}

}  // namespace

void addPageOptions(CLI::App& app, PageJob& job) {
  addText(app, "--page", "FILE", job.path,
          "write the result as a single HTML page with a 3D view, or - for standard output");
  addConverted(
      app, "--page-language", "en|de",
      [&job](const std::string& text) {
        if (text != "en" && text != "de")
          badOption("--page-language is '" + text + "'; allowed: en, de");
        job.language = text;
      },
      "language of the page (default en)");
  addText(app, "--page-title", "TEXT", job.title, "title of the page");
  addText(app, "--page-template", "FILE", job.templatePath,
          "HTML template to fill in, with {{placeholders}}, in place of the built-in template");
}

void checkPageOptions(const PageJob& job) {
  if (!job.path.empty()) return;
  if (!job.templatePath.empty()) badOption("--page-template can be used only together with --page");
  if (!job.title.empty()) badOption("--page-title can be used only together with --page");
}

void addTemplate(const PageJob& job, std::vector<RoledFile>& inputs) {
  if (!job.templatePath.empty()) inputs.push_back({"--page-template", job.templatePath});
}

PageInput inputRow(const std::string& role, const std::string& path) {
  if (isStream(path)) return {role, path == "-" ? "standard input" : path, "", ""};
  std::error_code code;
  const auto size = std::filesystem::file_size(pathFromUtf8(path), code);
  return {role, utf8FromPath(pathFromUtf8(path).filename()),
          code ? "" : std::to_string(size) + " bytes", sha256Of(path)};
}

PageFrame beginPage(const PageJob& job) {
  if (job.path.empty()) return {};
  PageFrame frame{"", dateText()};
  if (job.templatePath.empty()) return frame;
  std::ostringstream text;
  readRepeatably(job.templatePath,
                 [&text](const std::string& file) { text << opened(file).rdbuf(); });
  frame.layout = text.str();
  if (frame.layout.empty())
    throw Error(Status::InvalidInput, "BadTemplate", "'" + job.templatePath + "' is empty");
  checkPageTemplate(frame.layout);
  return frame;
}

std::string makePage(const PageJob& job, const PageFrame& frame, const std::string& report,
                     std::vector<PageInput> inputs, std::vector<PagePart> parts, RunContext& run) {
  PageOptions options;
  options.title = job.title;
  options.language = job.language;
  options.version = SWEPT_VERSION;
  options.date = frame.date;
  options.layout = frame.layout;
  options.inputs = std::move(inputs);
  options.parts = std::move(parts);
  return reportPage(report, options, run);
}

}  // namespace swept::cli
