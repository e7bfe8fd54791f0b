// SPDX-License-Identifier: MIT
#include "sampled.h"

#include "core/base/bytes.h"
#include "core/base/shader_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace grass;
using namespace grass::test;

namespace {

const int ROUNDS = sampled(3000); // damaged files that a test tries

using Bytes = std::vector<uint8_t>;

Bytes random_bytes(std::mt19937 &r_random, size_t p_count) {
	Bytes bytes(p_count);
	std::ranges::generate(bytes, [&] { return uint8_t(r_random()); });
	return bytes;
}

Bytes read(const std::string &p_key, const Bytes &p_file) {
	const std::span<const uint8_t> shader = read_shader_file(p_key, p_file);
	return { shader.begin(), shader.end() };
}

} // namespace

TEST_CASE("bytes: the checksum is the common CRC-32") {
	const char text[] = "123456789";
	CHECK(checksum(std::span(reinterpret_cast<const uint8_t *>(text), 9)) == 0xcbf43926u);
	CHECK(checksum({}) == 0u);
}

TEST_CASE("shader_file: a shader comes back as it was, by its own key") {
	std::mt19937 random(1);
	const std::vector<uint32_t> code = { 0x07230203u, 1, 2, 3 };
	for (const size_t size : { size_t(1), size_t(3), size_t(700), size_t(174000), SHADER_BYTES_MOST }) {
		const Bytes shader = random_bytes(random, size);
		const std::string key = shader_key({ "vulkan", "a card", std::string(size % 50, 'x') }, code);
		const Bytes file = write_shader_file(key, shader);
		CHECK(file.size() <= shader_file_bytes_most(key));
		CHECK(read(key, file) == shader);
	}
	const std::string key = shader_key({ "vulkan" }, code);
	CHECK(write_shader_file(key, Bytes()).empty());
	CHECK(write_shader_file(key, Bytes(SHADER_BYTES_MOST + 1)).empty());
	CHECK(write_shader_file(std::string(SHADER_KEY_BYTES_MOST + 1, 'k'), Bytes(1)).empty());
}

TEST_CASE("shader_file: another driver, version or code is another key, with another file") {
	const std::vector<uint32_t> code = { 0x07230203u, 1, 2, 3 };
	std::vector<uint32_t> changed = code, longer = code;
	changed[2] ^= 1u << 31;
	longer.push_back(0);
	const std::string key = shader_key({ "vulkan", "card", "1.3" }, code);
	const Bytes shader = { 1, 2, 3, 4 }, file = write_shader_file(key, shader);
	std::vector<std::string> names = { shader_file_name(key) };
	for (const std::string &other : { shader_key({ "d3d12", "card", "1.3" }, code), shader_key({ "vulkan", "care", "1.3" }, code),
				 shader_key({ "vulkan", "card", "1.4" }, code), shader_key({ "vulkan", "card" }, code), shader_key({}, code),
				 shader_key({ "vulkancard", "", "1.3" }, code), shader_key({ "vulkan", "card", "1.3" }, changed),
				 shader_key({ "vulkan", "card", "1.3" }, longer), shader_key({ "vulkan", "card", "1.3" }, {}) }) {
		CAPTURE(other);
		CHECK(read(other, file).empty());
		names.push_back(shader_file_name(other));
	}
	CHECK(shader_key({ "vulkan", "card", "1.3" }, code) == key);
	std::ranges::sort(names);
	CHECK(std::ranges::adjacent_find(names) == names.end());
	for (const std::string &name : names) {
		CHECK(name.size() == 23); // 16 digits and the suffix
		CHECK(is_shader_file_name(name));
		CHECK(is_shader_file_name(name + ".42.tmp"));
	}
	CHECK_FALSE(is_shader_file_name("picture.png"));
	CHECK_FALSE(is_shader_file_name(""));
}

TEST_CASE("shader_file: of a damaged file nothing is read") {
	std::mt19937 random(7);
	for (int round = 0; round < ROUNDS; round++) {
		const std::string key =
				shader_key({ "vulkan", std::to_string(round) }, std::vector<uint32_t>{ uint32_t(random()), uint32_t(random()) });
		const Bytes shader = random_bytes(random, 1 + random() % 600), whole = write_shader_file(key, shader);
		Bytes file = whole;
		switch (round % 6) {
			case 0: // one bit
				file[random() % file.size()] ^= uint8_t(1u << random() % 8);
				break;
			case 1: // cut off, down to nothing
				file.resize(random() % file.size());
				break;
			case 2: { // goes on
				const Bytes more = random_bytes(random, 1 + random() % 40);
				file.insert(file.end(), more.begin(), more.end());
				break;
			}
			case 3: { // a run of other bytes
				const size_t at = random() % file.size(), count = std::min<size_t>(1 + random() % 64, file.size() - at);
				std::ranges::copy(random_bytes(random, count), file.begin() + std::ptrdiff_t(at));
				break;
			}
			case 4: // sizes that lead out of it, or past each other
				for (const size_t at : { size_t(12), size_t(16) }) {
					const uint32_t size = random() % 3 ? uint32_t(random()) : 0xffffffffu - random() % 64;
					std::memcpy(&file[at], &size, 4);
				}
				break;
			case 5: // nothing of ours
				file = random_bytes(random, random() % 900);
				break;
		}
		CAPTURE(round);
		CHECK(read(key, file) == (file == whole ? shader : Bytes()));
	}
	const std::string key = shader_key({ "vulkan" }, {});
	CHECK(read(key, Bytes(shader_file_bytes_most(key) + 1)).empty());
}

TEST_CASE("shader_file: too many files lose the oldest ones") {
	std::mt19937 random(3);
	for (const size_t most : { size_t(1), size_t(5), size_t(64) }) {
		for (const size_t count : { size_t(0), most, most + 1, 3 * most }) {
			std::vector<KeptFile> files;
			for (size_t i = 0; i < count; i++) {
				files.push_back({ "file" + std::to_string(100 + i), 1000 + i });
			}
			std::ranges::shuffle(files, random);
			const std::vector<std::string> surplus = surplus_files(files, most);
			REQUIRE(surplus.size() == (count > most ? count - most : 0));
			for (size_t i = 0; i < surplus.size(); i++) {
				CHECK(surplus[i] == "file" + std::to_string(100 + i));
			}
		}
	}
	CHECK(surplus_files({ { "b", 7 }, { "a", 7 }, { "c", 7 } }, 2) == std::vector<std::string>{ "a" });
}
