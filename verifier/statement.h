// What the modules of the C++ verifier for sets share: how a statement is read, then checked.
#pragma once

#include "statement_reader.h"
#include "sunder_verify.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace sunder_verifier {

struct Statement {
  PairResult result;            // with names and verdict
  std::function<void()> check;  // throws Refused where the evidence does not hold
};

// Reads a statement. Throws Refused where its form is wrong.
using ReadStatement = std::function<Statement(const json& item, const std::string& where)>;

// How a statement is read, for each question.
using Questions = std::map<std::string, ReadStatement>;

Statement make_statement(const std::string& about, const std::string& rule, const std::string& verdict,
                         std::function<void()> check);

// Throws Refused where the condition does not hold.
void require(bool condition, const char* check, const std::string& reason);

constexpr std::size_t no_index = static_cast<std::size_t>(-1);

// A list of indices below `size`; of `count` entries, unless that is no_index.
std::vector<std::size_t> index_list(const json& item, const char* key, std::size_t size, std::size_t count,
                                    const std::string& where);
// The same, where -1 stands for no_index.
std::vector<std::size_t> index_or_none_list(const json& item, const char* key, std::size_t size, std::size_t count,
                                            const std::string& where);

// The rule of a statement, "nothing", "shared-endpoint" or "touch".
std::string read_rule(const json& item, const std::string& where);

// `groups` of an object: a whole number of at most 15 digits for each of `size`.
std::vector<std::int64_t> read_groups(const json& item, std::size_t size, const std::string& where);

bool is_minus_one(const json& value);

// T1: the events of a transcript are the ends 0 to 2 size - 1 of what the reason names, each once.
void require_each_end_once(const std::vector<std::size_t>& events, std::size_t size, const std::string& of);

}  // namespace sunder_verifier
