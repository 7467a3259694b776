// Archives that an attacker could hand in. The same seed gives the same archive.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

struct HostileArchive {
    std::string name;  ///< "x.zip", "x.tar", "x.tar.gz" or "x.tgz"
    std::string bytes;
    std::string what;  ///< the attack, for a test's message
};

/// How many attacks there are. The seeds below it give each once and undamaged.
std::uint32_t hostile_archive_kinds();

/// Attack number `seed` modulo hostile_archive_kinds(). Later seeds vary its sizes and names, and every second one is
/// also damaged: bits flipped, cut off, parts repeated.
HostileArchive hostile_archive(std::uint32_t seed);
