#include "durero/serve/server.hpp"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/socket.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/rays/hits_file.hpp"
#include "durero/io/source.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/whole_number.hpp"
#include "edit_feed.hpp"
#include "request.hpp"
#include "store_worker.hpp"

namespace durero::embedded {
const std::map<std::string, std::string>& schemas();
}

namespace durero::serve {
namespace {

using httplib::Request;
using httplib::Response;

constexpr const char* json_type = "application/json";
constexpr std::size_t most_bytes = std::size_t{64} << 20U;
constexpr std::size_t most_connections = 256;
/// How long whoever watches waits for an edit before a comment is sent, by which a connection that is gone is seen.
constexpr std::chrono::milliseconds heartbeat{15'000};

enum Status : int {
  done = 200,
  no_content = 204,
  bad = 400,
  unauthorized = 401,
  forbidden = 403,
  not_found = 404,
  conflict = 409,
  precondition_failed = 412,
  unsupported = 415,
  failed = 500
};

void answer(Response& out, std::string body, int status = done) {
  out.status = status;
  out.set_content(std::move(body), json_type);
}

void refuse(Response& out, int status, std::string_view wrong) {
  std::string body;
  io::json::Writer(body).begin_object().member("error", wrong).end_object();
  answer(out, std::move(body), status);
}

/// Tells that HEAD is not where the request asks it to be.
void refuse_stale(Response& out) {
  refuse(out, precondition_failed, "the scene is another by now; expected the ETag of this answer");
}

/// An entity tag: the event of a scene, in quotes.
std::string tag_of(store::EventNumber event) { return fmt::format("\"{}\"", event); }

/// The event that a request asks HEAD to be; no_event where it asks none, or any (*).
store::EventNumber expected_head(const Request& in) {
  const std::string given = in.get_header_value("If-Match");
  if (given.empty() || given == "*") return store::no_event;
  const bool quoted = given.size() > 2 && given.front() == '"' && given.back() == '"';
  const auto event = quoted ? text::whole_number(std::string_view(given).substr(1, given.size() - 2)) : std::nullopt;
  if (event && *event > 0 && std::in_range<store::EventNumber>(*event)) return static_cast<store::EventNumber>(*event);
  throw std::invalid_argument("If-Match is " + text::shown(given) + "; expected an ETag of this server");
}

/// Whether both are the same, in a time that tells nothing of where they differ.
bool is_same_secret(const std::string& a, const std::string& b) {
  unsigned char difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    difference = static_cast<unsigned char>(difference | (a[i] ^ b[i]));
  return difference == 0;
}

/// The host that a request names, without its port.
std::string named_host(const Request& in) {
  const std::string host = in.get_header_value("Host");
  if (host.starts_with('[')) return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

std::string event_json(const store::HistoryEvent& event) {
  std::string text;
  io::json::Writer out(text);
  out.begin_object()
      .member("event", static_cast<double>(event.number))
      .member("parent", static_cast<double>(event.parent));
  out.member("begins", event.begins).member("operation", std::string_view(event.operation));
  out.member("author", std::string_view(event.by.author)).member("time", std::string_view(event.by.time));
  out.member("comment", std::string_view(event.by.comment)).end_object();
  return text;
}

store::StoreAccess access_for(const ServerOptions& options) {
  return options.read_only ? store::StoreAccess::follow : store::StoreAccess::write;
}

}  // namespace

bool is_loopback(const std::string& host) {
  return host == "localhost" || host == "::1" || host == "[::1]" || host.starts_with("127.");
}

struct Server::Parts {
  Parts(const std::string& store, ServerOptions given)
      : options(std::move(given)), worker(store, access_for(options), feed) {
    if (!is_loopback(options.host) && options.token.empty())
      throw std::invalid_argument(
          fmt::format("{} is reached from other machines; expected a token, or 127.0.0.1", options.host));
    http.new_task_queue = [] { return new httplib::ThreadPool(most_connections); };
    http.set_payload_max_length(most_bytes);
    http.set_tcp_nodelay(true);
    http.set_keep_alive_timeout(60);
    // The library's own options let a second server listen at the same port.
    http.set_socket_options([this](socket_t made) {
      const int yes = 1;
      ::setsockopt(made, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
      listening = made;
    });
    http.set_keep_alive_max_count(std::numeric_limits<std::size_t>::max());
    http.set_pre_routing_handler([this](const Request& in, Response& out) { return admit(in, out); });
    http.set_exception_handler([](const Request&, Response& out, std::exception_ptr error) { tell(out, error); });
    http.set_error_handler([](const Request& in, Response& out) {
      if (out.body.empty()) refuse(out, out.status, fmt::format("nothing answers {} {}", in.method, in.path));
    });
    add_routes();
    bound = options.port == 0 ? http.bind_to_any_port(options.host) : options.port;
    const bool listens = options.port == 0 ? bound > 0 : http.bind_to_port(options.host, options.port);
    if (!listens)
      throw std::runtime_error(fmt::format(
          "cannot listen at {}:{}; expected an address of this machine, and a free port", options.host, options.port));
    ::listen(listening, SOMAXCONN);  // the library lets five connections wait, and turns others away
  }

  /// Tells what the request has done wrong.
  static void tell(Response& out, const std::exception_ptr& thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const io::InputError& error) {
      refuse(out, bad, error.what());
    } catch (const std::invalid_argument& error) {
      refuse(out, bad, error.what());
    } catch (const std::domain_error& error) {
      refuse(out, bad, error.what());
    } catch (const std::exception& error) {
      refuse(out, failed, error.what());
    }
  }

  /// Refuses a request whose body is not read: the connection ends, so that the body is not taken for another request.
  static httplib::Server::HandlerResponse turn_away(Response& out, int status, const char* error) {
    out.set_header("Connection", "close");
    refuse(out, status, error);
    return httplib::Server::HandlerResponse::Handled;
  }

  /// Whether somebody may ask at all. A page of another origin may not, by a name of this machine that it has made up
  /// (DNS), or by a request that a browser sends unasked.
  httplib::Server::HandlerResponse admit(const Request& in, Response& out) const {
    using enum httplib::Server::HandlerResponse;
    if (!options.origin.empty()) {
      out.set_header("Access-Control-Allow-Origin", options.origin);
      out.set_header("Access-Control-Allow-Headers", "authorization, content-type, if-match");
      out.set_header("Access-Control-Expose-Headers", "etag");
      out.set_header("Vary", "Origin");
    }
    if (in.method == "OPTIONS") {
      out.status = no_content;
      return Handled;
    }
    if (options.token.empty()) {
      if (!is_loopback(named_host(in))) {
        return turn_away(out, forbidden, "the request names another host; expected this machine");
      }
    } else if (!is_same_secret(in.get_header_value("Authorization"), "Bearer " + options.token)) {
      out.set_header("WWW-Authenticate", "Bearer");
      return turn_away(out, unauthorized, "no token, or another; expected Authorization: Bearer TOKEN");
    }
    if (in.method == "POST" && !in.get_header_value("Content-Type").starts_with(json_type)) {
      return turn_away(out, unsupported, "the body has another type; expected Content-Type: application/json");
    }
    return Unhandled;
  }

  void add_routes() {
    http.Get("/", [this](const Request&, Response& out) { tell_head(out); });
    http.Get("/scene", [this](const Request&, Response& out) {
      const auto scene = worker.scene();
      out.set_header("ETag", tag_of(scene->event()));
      answer(out, io::scene_text(scene->grouped().scene, scene->grouped().groups));
    });
    http.Get("/log", [this](const Request& in, Response& out) { tell_log(in, out); });
    http.Get("/events", [this](const Request& in, Response& out) { watch(in, out); });
    http.Get("/schema", [](const Request&, Response& out) {
      std::string body;
      io::json::Writer list(body);
      list.begin_array();
      for (const auto& [name, text] : embedded::schemas()) list.value(std::string_view(name));
      list.end_array();
      answer(out, std::move(body));
    });
    http.Get(R"(/schema/([a-z-]+\.schema\.json))", [](const Request& in, Response& out) {
      const auto found = embedded::schemas().find(in.matches[1].str());
      if (found == embedded::schemas().end()) return refuse(out, not_found, "there is no such schema");
      answer(out, found->second);
    });
    http.Post("/hits", [this](const Request& in, Response& out) { tell_hits(in, out); });
    if (options.read_only) {
      http.Post("/(edits|undo|redo)", [](const Request&, Response& out) {
        refuse(out, forbidden, "the store is only read here; expected the server that writes it");
      });
      return;
    }
    http.Post("/edits", [this](const Request& in, Response& out) { edit(in, out); });
    http.Post("/undo", [this](const Request& in, Response& out) { move(in, out, &store::Store::undo, "undone"); });
    http.Post("/redo", [this](const Request& in, Response& out) { move(in, out, &store::Store::redo, "redone"); });
  }

  void tell_head(Response& out) {
    const store::StoreHead head = worker.ask([](store::Store& of) { return of.head(); });
    std::string body;
    io::json::Writer(body)
        .begin_object()
        .member("server", "durero")
        .member("branch", std::string_view(head.branch))
        .member("event", static_cast<double>(head.event))
        .end_object();
    out.set_header("ETag", tag_of(head.event));
    answer(out, std::move(body));
  }

  /// The last events up to HEAD, the last first.
  void tell_log(const Request& in, Response& out) {
    constexpr std::size_t most = 1000;
    std::size_t count = 100;
    if (in.has_param("limit")) {
      const std::string given = in.get_param_value("limit");
      count = text::whole_number(given).value_or(0);
      if (count == 0 || count > most)
        throw std::invalid_argument(fmt::format("limit is {}; expected 1 to {}", text::shown(given), most));
    }
    answer(out, worker.ask([count](store::Store& of) {
      std::string body = "[";
      store::EventNumber at = of.head().event;
      for (std::size_t i = 0; i < count && at != store::no_event; ++i) {
        const store::HistoryEvent event = of.event(at);
        body.append(i == 0 ? "" : ",").append(event_json(event));
        at = event.parent;
      }
      return body + "]";
    }));
  }

  void edit(const Request& in, Response& out) {
    AskedEdit asked = read_edit(in.body, options.author);
    asked.expected = expected_head(in);
    const bool all_or_nothing = asked.all_or_nothing;
    const EditOutcome outcome = worker.edit(std::move(asked));
    out.set_header("ETag", tag_of(outcome.head));
    if (outcome.is_stale) return refuse_stale(out);
    const bool is_refused = all_or_nothing && outcome.result.is_refused;
    answer(out, fmt::format(R"({{"event":{},"answers":{}}})", outcome.head, as_array(outcome.result.answers)),
           is_refused ? conflict : done);
  }

  /// To where undo() or redo() leads.
  void move(const Request& in, Response& out, std::optional<store::EventNumber> (store::Store::*step)(),
            std::string_view what) {
    const store::EventNumber expected = expected_head(in);
    const auto [head, is_stale, is_moved] = worker.ask([&](store::Store& of) {
      const store::EventNumber before = of.head().event;
      if (expected != store::no_event && expected != before) return std::tuple(before, true, false);
      const auto after = (of.*step)();
      if (after) feed.send(fmt::format(R"({{"event":{},"{}":true}})", *after, what));
      return std::tuple(after.value_or(before), false, after.has_value());
    });
    out.set_header("ETag", tag_of(head));
    if (is_stale) return refuse_stale(out);
    if (!is_moved) return refuse(out, conflict, fmt::format("nothing can be {}", what));
    answer(out, fmt::format(R"({{"event":{}}})", head));
  }

  void tell_hits(const Request& in, Response& out) {
    const auto at = worker.scene();
    const scene::Scene& scene = at->grouped().scene;
    const std::vector<scene::Query> rays = read_rays(in.body, scene);
    const std::vector<scene::Hit> hits = engine::first_hits(at->engine(), rays);
    std::string body = fmt::format(R"({{"event":{},"hits":[)", at->event());
    for (std::size_t i = 0; i < hits.size(); ++i)
      body.append(i == 0 ? "" : ",").append(io::hit_text(i, hits[i], scene));
    out.set_header("ETag", tag_of(at->event()));
    answer(out, body + "]}");
  }

  /// Server-sent events, from the next edit on, or from behind the one that Last-Event-ID names.
  void watch(const Request& in, Response& out) {
    std::uint64_t last = feed.last();
    const std::string given = in.get_header_value("Last-Event-ID");
    if (!given.empty()) {
      const auto number = text::whole_number(given);
      if (!number)
        throw std::invalid_argument("Last-Event-ID is " + text::shown(given) + "; expected an id of this server");
      last = *number;
    }
    out.set_header("Cache-Control", "no-store");
    out.set_chunked_content_provider("text/event-stream", [this, last](std::size_t, httplib::DataSink& sink) mutable {
      const auto message = feed.after(last, heartbeat);
      if (feed.is_closed()) {
        sink.done();
        return true;
      }
      const std::string text =
          message ? fmt::format("id: {}\ndata: {}\n\n", message->number, message->text) : std::string(": \n\n");
      if (message) last = message->number;
      return sink.write(text.data(), text.size());
    });
  }

  ServerOptions options;
  EditFeed feed{};
  StoreWorker worker;
  httplib::Server http{};
  int bound = 0;
  socket_t listening = 0;
};

Server::Server(const std::string& store, ServerOptions options)
    : parts_(std::make_unique<Parts>(store, std::move(options))) {}

Server::~Server() { stop(); }

int Server::port() const noexcept { return parts_->bound; }

void Server::run() { parts_->http.listen_after_bind(); }

void Server::stop() noexcept {
  parts_->feed.close();
  parts_->http.stop();
}

}  // namespace durero::serve
