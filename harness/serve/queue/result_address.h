// The address of a student's result. Nobody can guess it, so students need no account.
#pragma once

#include <string>
#include <string_view>

namespace harness::serve {

/// 128 random bits as 32 lower-case hexadecimal digits. Throws HarnessError if the machine has no random numbers.
std::string new_result_address();

bool is_result_address(std::string_view text);

/// The key of a result in the spool: a hash of its address, so the spool and its backups do not reveal the address.
std::string key_of(const std::string& result_address);

}  // namespace harness::serve
