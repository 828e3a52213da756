#include "durero/serve/server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <atomic>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "durero/store/store.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

namespace durero::serve {
namespace {

constexpr const char* json = "application/json";

/// A new store, served as long as it lives.
class Served {
 public:
  explicit Served(ServerOptions options = {}) {
    store::Store::create(file(), {}, "", {"tester", "2026-01-31T12:00:00Z", ""});
    start(std::move(options));
  }
  ~Served() { end(); }

  void start(ServerOptions options) {
    server_ = std::make_unique<Server>(file(), std::move(options));
    thread_ = std::thread([this] { server_->run(); });
    while (!client().Get("/").operator bool()) std::this_thread::yield();
  }
  void end() {
    if (!server_) return;
    server_->stop();
    thread_.join();
    server_.reset();
  }

  std::string file() const { return folder_.file("room.store"); }
  int port() const { return server_->port(); }
  httplib::Client client() const {
    httplib::Client client("127.0.0.1", server_->port());
    client.set_keep_alive(true);
    client.set_tcp_nodelay(true);
    client.set_read_timeout(60);
    return client;
  }

 private:
  test::Folder folder_{};
  std::unique_ptr<Server> server_{};
  std::thread thread_{};
};

std::string edit_of(const std::string& operation) { return fmt::format(R"({{"operations":["{}"]}})", operation); }
std::string sphere(const std::string& name) {
  return edit_of(fmt::format("Agregar_Esfera e?={} centro?=(0,0,5) radio?=1", name));
}

int status(const httplib::Result& answer) { return answer ? answer->status : -1; }

}  // namespace

TEST_CASE("an edit is done, or refused with its predicate, and the scene tells") {
  const Served served;
  httplib::Client client = served.client();
  auto answer = client.Post("/edits", sphere("a"), json);
  REQUIRE(status(answer) == 200);
  CHECK(answer->body == R"({"event":2,"answers":[{"line":1,"ok":true,"r":"esfera_agregada"}]})");
  CHECK(answer->get_header_value("ETag") == "\"2\"");
  answer = client.Post("/edits", sphere("a"), json);
  CHECK(status(answer) == 200);
  CHECK(answer->body.find(R"("violated":"Agregar_Elemento.pre.1")") != std::string::npos);
  answer = client.Get("/scene");
  CHECK(answer->get_header_value("ETag") == "\"2\"");
  CHECK(answer->body.find(R"("id":"a","tipo":"esfera")") != std::string::npos);
  answer = client.Post("/hits", R"({"rays":[[0,0,0,0,0,1],{"ray":[0,0,4,0,0,1],"on":["a"]},[0,9,0,0,0,1]]})", json);
  CHECK(
      answer->body ==
      R"({"event":2,"hits":[{"ray":0,"outcome":"hit","elementos":["a"],"t":4,"point":[0,0,4]},)"
      R"({"ray":1,"outcome":"hit","elementos":["a"],"t":2,"point":[0,0,6]},{"ray":2,"outcome":"miss","elementos":[]}]})");
  answer = client.Get("/log?limit=1");
  CHECK(answer->body.find(R"("event":2,"parent":1)") != std::string::npos);
  CHECK(client.Get("/")->body == R"({"server":"durero","branch":"main","event":2})");
}

TEST_CASE("all or nothing, undo and redo") {
  const Served served;
  httplib::Client client = served.client();
  const std::string both =
      R"({"all_or_nothing":true,"comment":"two","operations":["Agregar_Esfera e=a centro=(0,0,5) radio=1",
{"op":"Agregar_Esfera","e":"b","centro":[0,0,9],
"radio":0}]})";
  CHECK(status(client.Post("/edits", both, json)) == 409);
  CHECK(client.Get("/scene")->body.find("esfera") == std::string::npos);
  std::string right = both;
  right.replace(right.find(":0}"), 3, ":2}");
  CHECK(status(client.Post("/edits", right, json)) == 200);
  CHECK(client.Post("/undo", "", json)->body == R"({"event":1})");
  CHECK(client.Get("/scene")->body.find("esfera") == std::string::npos);
  CHECK(status(client.Post("/undo", "", json)) == 409);
  CHECK(client.Post("/redo", "", json)->body == R"({"event":3})");
  CHECK(client.Get("/scene")->body.find(R"("id":"b")") != std::string::npos);
}

TEST_CASE("a lost update is refused") {
  const Served served;
  httplib::Client client = served.client();
  const std::string first = client.Get("/")->get_header_value("ETag");
  CHECK(status(client.Post("/edits", {{"If-Match", first}}, sphere("a"), json)) == 200);
  const auto stale = client.Post("/edits", {{"If-Match", first}}, sphere("b"), json);
  CHECK(status(stale) == 412);
  CHECK(status(client.Post("/undo", {{"If-Match", first}}, "", json)) == 412);
  CHECK(client.Get("/scene")->body.find(R"("id":"b")") == std::string::npos);
  CHECK(status(client.Post("/edits", {{"If-Match", stale->get_header_value("ETag")}}, sphere("b"), json)) == 200);
  CHECK(status(client.Post("/edits", {{"If-Match", "2"}}, sphere("c"), json)) == 400);
  CHECK(status(client.Post("/edits", {{"If-Match", "*"}}, sphere("c"), json)) == 200);
}

TEST_CASE("whoever watches is told of each edit, in order") {
  const Served served;
  std::string heard;
  std::atomic<bool> is_open = false;
  std::thread watcher([&] {
    httplib::Client client = served.client();
    client.Get(
        "/events", {{"Last-Event-ID", "0"}},
        [&](const httplib::Response&) {
          is_open = true;
          return true;
        },
        [&](const char* data, std::size_t size) {
          heard.append(data, size);
          return heard.find("\"event\":3") == std::string::npos;
        });
  });
  while (!is_open) std::this_thread::yield();
  httplib::Client client = served.client();
  client.Post("/edits", sphere("a"), json);
  client.Post("/edits", sphere("a"), json);  // refused: nothing to tell
  client.Post("/edits", sphere("b"), json);
  watcher.join();
  CHECK(heard ==
        "id: 1\ndata: {\"event\":2,\"answers\":[{\"line\":1,\"ok\":true,\"r\":\"esfera_agregada\"}]}\n\n"
        "id: 2\ndata: {\"event\":3,\"answers\":[{\"line\":1,\"ok\":true,\"r\":\"esfera_agregada\"}]}\n\n");
}

TEST_CASE("a server that only reads refuses edits, and follows those of others") {
  ServerOptions reading;
  reading.read_only = true;
  const Served served(reading);
  httplib::Client client = served.client();
  for (const char* const path : {"/edits", "/undo", "/redo"}) {
    const auto answer = client.Post(path, sphere("a"), json);
    CHECK(status(answer) == 403);
    CHECK(answer->body == R"({"error":"the store is only read here; expected the server that writes it"})");
  }
  std::string heard;
  std::atomic<int> count = 0;
  std::thread watcher([&] {
    httplib::Client watching = served.client();
    watching.Get("/events", {{"Last-Event-ID", "0"}}, [&](const char* data, std::size_t size) {
      heard.append(data, size);
      return ++count < 2;
    });
  });
  store::Store writer(served.file(), store::StoreAccess::write);
  for (int event = 2; event <= 3; ++event) {
    const io::Source script("script", fmt::format("Agregar_Esfera e?=s{} centro?=(0,0,5) radio?=1\n", event));
    writer.edit({script, 0, {"ann", "2026-01-31T12:00:00Z", ""}});
    CHECK(client.Get("/")->body == fmt::format(R"({{"server":"durero","branch":"main","event":{}}})", event));
    CHECK(client.Post("/hits", R"({"rays":[[0,0,0,0,0,1]]})", json)->body.find(fmt::format("\"s{}\"", event)) !=
          std::string::npos);
    while (count < event - 1) std::this_thread::yield();
  }
  watcher.join();
  CHECK(heard == "id: 1\ndata: {\"event\":2}\n\nid: 2\ndata: {\"event\":3}\n\n");
}

TEST_CASE("fifty clients at a time lose nothing, and the store has it when the server is gone") {
  Served served;
  constexpr int clients = 50, edits = 20;
  std::vector<std::thread> threads;
  std::atomic<int> accepted = 0;
  for (int c = 0; c < clients; ++c)
    threads.emplace_back([&, c] {
      httplib::Client client = served.client();
      for (int i = 0; i < edits; ++i) {
        const auto answer = client.Post("/edits", sphere(fmt::format("c{}-{}", c, i)), json);
        if (status(answer) == 200 && answer->body.find("\"ok\":true") != std::string::npos) ++accepted;
      }
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(accepted == clients * edits);
  served.end();
  store::Store store(served.file(), store::StoreAccess::read);
  CHECK(store.state(store.head().event).scene.size() == clients * edits);
}

TEST_CASE("bad input is refused in one line, and changes nothing") {
  const Served served;
  httplib::Client client = served.client();
  const auto wrong = [&](const char* path, const std::string& body) {
    const auto answer = client.Post(path, body, json);
    REQUIRE(answer);
    CHECK(answer->body.find("\"error\"") != std::string::npos);
    CHECK(answer->body.find('\n') == std::string::npos);
    return answer->status;
  };
  for (const char* const body :
       {"", "{", "[]", "{}", R"({"operations":3})", R"({"operations":[3]})", R"({"operations":["Agregar"]})",
        R"({"operations":["Eliminar_Esfera e=a\nEliminar_Esfera e=b"]})", R"({"operations":[],"more":1})",
        R"({"operations":[],"comment":"a\nb"})", R"({"operations":[{"op":"Nothing"}]})"})
    CHECK(wrong("/edits", body) == 400);
  for (const char* const body :
       {R"({"rays":[[0,0,0,0,0,0]]})", R"({"rays":[[0,0,0,0,0]]})", R"({"rays":[[1e999,0,0,0,0,1]]})",
        R"({"rays":[{"ray":[0,0,0,0,0,1],"on":["nobody"]}]})", R"({"rays":[{"on":[]}]})"})
    CHECK(wrong("/hits", body) == 400);
  CHECK(status(client.Get("/nothing")) == 404);
  CHECK(status(client.Get("/schema/nothing.schema.json")) == 404);
  for (const char* limit : {"0", "1001", "-1", "1.0", ""})
    CHECK(status(client.Get(std::string("/log?limit=") + limit)) == 400);
  for (const char* id : {"x", "-1", "1.0"}) CHECK(status(client.Get("/events", {{"Last-Event-ID", id}})) == 400);
  CHECK(status(client.Post("/edits", sphere("a"), "text/plain")) == 415);
  CHECK(client.Post("/edits", sphere("a"), "text/plain")->get_header_value("Connection") == "close");
  CHECK_THAT(client.Get("/")->body, Catch::Contains("\"event\":1"));

  std::mt19937_64 random(7);
  const std::string seeds[] = {sphere("a"), R"({"rays":[[0,0,0,0,0,1]]})"};
  for (int i = 0; i < 500; ++i) {
    std::string body = seeds[random() % 2];
    for (int changes = static_cast<int>(random() % 4) + 1; changes > 0; --changes)
      body[random() % body.size()] = static_cast<char>(random() % 256);
    for (const char* const path : {"/edits", "/hits"}) {
      const int given = status(client.Post(path, body, json));
      CHECK((given == 200 || given == 400));
    }
  }
}

TEST_CASE("without the token nobody is answered, and at other addresses none goes without") {
  CHECK(is_loopback("127.0.0.1"));
  CHECK(is_loopback("localhost"));
  CHECK(!is_loopback("0.0.0.0"));
  CHECK(!is_loopback("192.168.0.7"));
  const test::Folder folder;
  store::Store::create(folder.file("s"), {}, "", {});
  ServerOptions everywhere;
  everywhere.host = "0.0.0.0";
  CHECK_THROWS_AS(Server(folder.file("s"), everywhere), std::invalid_argument);

  ServerOptions secret;
  secret.token = "open sesame";
  const Served served(secret);
  httplib::Client client = served.client();
  CHECK(status(client.Get("/scene")) == 401);
  CHECK(status(client.Get("/scene", {{"Authorization", "Bearer open sesam"}})) == 401);
  CHECK(status(client.Get("/scene", {{"Authorization", "Bearer open sesame"}})) == 200);
}

TEST_CASE("pages of other origins, and names that a stranger gives this machine, are refused") {
  const Served served;
  httplib::Client client = served.client();
  CHECK(status(client.Get("/scene", {{"Host", "evil.example"}})) == 403);
  CHECK(status(client.Get("/scene", {{"Host", "localhost:80"}})) == 200);
  CHECK(client.Options("/edits")->get_header_value("Access-Control-Allow-Origin").empty());
  ServerOptions with_page;
  with_page.origin = "null";
  const Served open(with_page);
  CHECK(open.client().Options("/edits")->get_header_value("Access-Control-Allow-Origin") == "null");
}

TEST_CASE("two servers do not listen at one port") {
  const Served served;
  const test::Folder folder;
  store::Store::create(folder.file("other"), {}, "", {});
  ServerOptions same;
  same.port = served.port();
  CHECK_THROWS_AS(Server(folder.file("other"), same), std::runtime_error);
}

TEST_CASE("the schemas are published") {
  const Served served;
  httplib::Client client = served.client();
  CHECK(client.Get("/schema")->body.find("\"operation.schema.json\"") != std::string::npos);
  CHECK(client.Get("/schema/operation.schema.json")->body.find("Agregar_Esfera") != std::string::npos);
}

}  // namespace durero::serve
