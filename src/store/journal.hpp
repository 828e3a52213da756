#pragma once
/// What an open store consists of, and how a change of it is one transaction of its database.

#include "durero/store/store.hpp"
#include "fold.hpp"
#include "records.hpp"

namespace durero::store {

struct Journal {
  Journal(const std::string& path, Database::Mode mode) : opened(open_database(path, mode)) {}

  std::unique_ptr<Database> opened;
  Database& database = *opened;
  Records records{database};
  Fold fold{records};
};

/// A transaction of the database. Without commit() nothing of it is kept, and the fold, which may have gone on, is
/// forgotten.
class WriteTransaction {
 public:
  /// Waits until no other program writes.
  explicit WriteTransaction(Journal& journal) : journal_(journal) { journal.database.begin_writing(); }
  ~WriteTransaction();
  WriteTransaction(const WriteTransaction&) = delete;
  WriteTransaction& operator=(const WriteTransaction&) = delete;

  /// Keeps it, on disk.
  void commit();

 private:
  Journal& journal_;
  bool is_open_ = true;
};

/// Where HEAD is, and how it moves.
StoreHead head_of(Records& records);
/// The branch of HEAD, or HEAD itself, stands on that event.
void move_head(Records& records, const StoreHead& head, EventNumber to);

/// Keeps an event under its number, which no other has, behind that of its parent, with its hash, which is made here.
/// The snapshot of an import is its content.
void append(Records& records, HistoryEvent& event, const Digest& parent, std::string_view snapshot = {});

}  // namespace durero::store
