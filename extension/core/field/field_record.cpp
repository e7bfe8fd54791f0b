// SPDX-License-Identifier: MIT
#include "core/field/field_record.h"

#include "core/base/bytes.h"

#include <algorithm>
#include <bit>
#include <string_view>
#include <type_traits>

namespace grass {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are in memory");

namespace {

constexpr std::string_view MAGIC = "GRASSREC";
constexpr size_t HEADER_BYTES = 12, PART_HEADER_BYTES = 16; // the latter: kind, size, packed size, checksum of the packed bytes
constexpr size_t END_BYTES_MOST = 1024; // of a sentence

class TickWriter {
public:
	explicit TickWriter(std::vector<uint8_t> &r_bytes) : _bytes(r_bytes) {}

	template <typename T> void value(const T &p_value) {
		static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
		const uint8_t *first = reinterpret_cast<const uint8_t *>(&p_value);
		_bytes.insert(_bytes.end(), first, first + sizeof(T));
	}
	template <typename T, typename F> void list(const std::vector<T> &p_list, F &&p_each) {
		value(uint32_t(p_list.size()));
		std::ranges::for_each(p_list, p_each);
	}

private:
	std::vector<uint8_t> &_bytes;
};

class TickReader {
public:
	TickReader(std::span<const uint8_t> p_bytes, size_t p_at) : _bytes(p_bytes), _at(p_at) {}

	template <typename T> void value(T &r_value) {
		static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
		_is_good = _is_good && _bytes.size() - _at >= sizeof(T);
		if (_is_good) {
			std::memcpy(&r_value, &_bytes[_at], sizeof(T));
			_at += sizeof(T);
		}
	}
	// Reads a list. An entry has at least a byte, so no list can take more entries than the file has bytes.
	template <typename T, typename F> void list(std::vector<T> &r_list, F &&p_each) {
		uint32_t count = 0;
		value(count);
		_is_good = _is_good && count <= _bytes.size() - _at;
		r_list.clear();
		for (uint32_t i = 0; i < count && _is_good; i++) {
			p_each(r_list.emplace_back());
		}
	}
	bool is_good() const { return _is_good; }
	size_t get_at() const { return _at; }

private:
	std::span<const uint8_t> _bytes;
	size_t _at;
	bool _is_good = true;
};

// Passes the members of a tick in the file's order, in both directions: what TickWriter writes, TickReader finds.
template <typename Stream, typename Params> void pass_solver(Stream &r_stream, Params &r_params) {
	r_stream.value(r_params.natural_frequency);
	r_stream.value(r_params.damping_ratio);
	r_stream.value(r_params.taper);
	r_stream.value(r_params.width_to_thickness);
	r_stream.value(r_params.root_stiffness);
	r_stream.value(r_params.bend_stiffness);
	r_stream.value(r_params.friction);
	r_stream.value(r_params.swing_speed_max);
	r_stream.value(r_params.iterations);
	r_stream.value(r_params.contact_rate);
	for (auto &load : r_params.load) {
		r_stream.value(load);
	}
}

template <typename Stream, typename Vector> void pass_vector(Stream &r_stream, Vector &r_vector) {
	for (int i = 0; i < int(r_vector.size()); i++) {
		r_stream.value(r_vector[i]);
	}
}

template <typename Stream, typename Pose> void pass_pose(Stream &r_stream, Pose &r_pose) {
	pass_vector(r_stream, r_pose.position);
	pass_vector(r_stream, r_pose.rotation.coeffs());
}

// Leaves out `growth` and `stamp`: the one is computed, the other promises what a file cannot keep.
template <typename Stream, typename Shape> void pass_shape(Stream &r_stream, Shape &r_shape) {
	r_stream.value(r_shape.type);
	pass_vector(r_stream, r_shape.size);
	r_stream.value(r_shape.owner);
	r_stream.value(r_shape.friction);
	r_stream.list(r_shape.planes, [&](auto &r_plane) { pass_vector(r_stream, r_plane); });
	pass_pose(r_stream, r_shape.now);
	pass_pose(r_stream, r_shape.before);
	r_stream.value(r_shape.force);
	r_stream.value(r_shape.air);
	r_stream.value(r_shape.revision);
}

template <typename Stream, typename Blowing> void pass_force(Stream &r_stream, Blowing &r_force) {
	r_stream.value(r_force.kind);
	pass_vector(r_stream, r_force.place);
	pass_vector(r_stream, r_force.direction);
	r_stream.value(r_force.speed);
	r_stream.value(r_force.radius);
	r_stream.value(r_force.duration);
	r_stream.value(r_force.turbulence);
	r_stream.value(r_force.age);
}

template <typename Stream, typename Params> void pass_params(Stream &r_stream, Params &r_params) {
	pass_solver(r_stream, r_params.solver);
	r_stream.list(r_params.species, [&](auto &r_species) { pass_solver(r_stream, r_species); });
	r_stream.value(r_params.sleep_mode);
	r_stream.value(r_params.sleep_delay);
	r_stream.value(r_params.sleep_motion);
	r_stream.value(r_params.contact_distance);
	r_stream.value(r_params.settle_time);
}

template <typename Stream, typename Tick> void pass_tick(Stream &r_stream, Tick &r_tick) {
	r_stream.value(r_tick.number);
	r_stream.value(r_tick.delta);
	r_stream.value(r_tick.slots);
	pass_params(r_stream, r_tick.params);
	r_stream.list(r_tick.changes, [&](auto &r_byte) { r_stream.value(r_byte); });
	r_stream.list(r_tick.colliders, [&](auto &r_shape) { pass_shape(r_stream, r_shape); });
	r_stream.list(r_tick.forces, [&](auto &r_force) { pass_force(r_stream, r_force); });
	r_stream.value(r_tick.hash);
}

std::vector<uint8_t> bytes_of(const FieldParams &p_params) {
	std::vector<uint8_t> bytes;
	TickWriter writer(bytes);
	pass_params(writer, p_params);
	return bytes;
}

// Brings the numbers of a tick within those that properties can have. TileManager repairs the colliders itself.
void repair(FieldParams &r_params) {
	r_params.solver = r_params.solver.sanitised();
	for (SolverParams &species : r_params.species) {
		species = species.sanitised();
	}
	r_params.sleep_mode = r_params.sleep_mode == SleepMode::TIMER ? SleepMode::TIMER : SleepMode::ENERGY;
	r_params.sleep_delay = SLEEP_DELAY.clamp(r_params.sleep_delay);
	r_params.sleep_motion = SLEEP_MOTION.clamp(r_params.sleep_motion);
	r_params.contact_distance = CONTACT_DISTANCE.clamp(r_params.contact_distance);
	r_params.settle_time = SETTLE_TIME.clamp(r_params.settle_time);
	r_params.detail = SimulationDetail::WHOLE;
	r_params.budget = 0.0;
}

bool is_possible(const TickRecord &p_tick) {
	return p_tick.forces.size() <= GRASS_MAX_FORCES && p_tick.params.species.size() <= GRASS_MAX_SPECIES &&
			std::ranges::all_of(p_tick.forces,
					[](const Force &p_force) { return p_force.kind >= ForceKind::BLAST && p_force.kind <= ForceKind::WIND; }) &&
			std::ranges::all_of(p_tick.colliders, [&](const ColliderShape &p_shape) {
				return p_shape.force >= ColliderShape::NO_FORCE && p_shape.force < int(p_tick.forces.size());
			});
}

} // namespace

void write_tick(std::vector<uint8_t> &r_bytes, const TickRecord &p_tick) {
	TickWriter writer(r_bytes);
	pass_tick(writer, p_tick);
}

bool read_tick(std::span<const uint8_t> p_bytes, size_t &r_at, TickRecord &r_tick) {
	TickReader reader(p_bytes, r_at);
	pass_tick(reader, r_tick);
	if (!reader.is_good() || !is_possible(r_tick)) {
		return false;
	}
	r_at = reader.get_at();
	repair(r_tick.params);
	r_tick.slots = std::clamp(r_tick.slots, 0, int(TileParams::MAX_POOL_SIZE));
	std::ranges::for_each(r_tick.forces, &Force::sanitise);
	return true;
}

bool are_recorded_alike(const FieldParams &p_a, const FieldParams &p_b) {
	return bytes_of(p_a) == bytes_of(p_b);
}

std::vector<uint8_t> begin_record() {
	std::vector<uint8_t> bytes(MAGIC.begin(), MAGIC.end());
	put_u32(bytes, RECORD_VERSION);
	return bytes;
}

std::vector<uint8_t> pack_part(RecordKind p_kind, std::span<const uint8_t> p_bytes, const MapCodec &p_codec) {
	const MapBytes packed = p_codec.pack(p_bytes);
	std::vector<uint8_t> part;
	for (const uint32_t value : { uint32_t(p_kind), uint32_t(p_bytes.size()), uint32_t(packed.size()), checksum(packed) }) {
		put_u32(part, value);
	}
	part.insert(part.end(), packed.begin(), packed.end());
	return part;
}

std::string RecordReader::open(std::vector<uint8_t> p_bytes) {
	*this = {};
	_bytes = std::move(p_bytes);
	_at = HEADER_BYTES;
	if (_bytes.size() < HEADER_BYTES || !std::equal(MAGIC.begin(), MAGIC.end(), _bytes.begin())) {
		return "is no record of grass: it does not begin as one";
	}
	if (const uint32_t version = get_u32(_bytes, MAGIC.size()); version != RECORD_VERSION) {
		return "has version " + std::to_string(version) + " of the format, but this add-on reads version " + std::to_string(RECORD_VERSION);
	}
	return {};
}

std::optional<RecordPart> RecordReader::end(const std::string &p_reason, bool p_is_broken) {
	_at = _bytes.size();
	_end = p_reason;
	_is_broken = p_is_broken;
	return {};
}

std::optional<RecordPart> RecordReader::read(const MapCodec &p_codec) {
	if (!_end.empty()) {
		return {};
	}
	const std::string name = "part " + std::to_string(_parts + 1);
	if (_bytes.size() - _at < PART_HEADER_BYTES) {
		return end("was cut off before " + name);
	}
	const uint32_t kind = get_u32(_bytes, _at), size = get_u32(_bytes, _at + 4), packed_size = get_u32(_bytes, _at + 8);
	const std::span<const uint8_t> rest = std::span(_bytes).subspan(_at + PART_HEADER_BYTES);
	const size_t size_most = kind == uint32_t(RecordKind::END) ? END_BYTES_MOST : RECORD_PART_MOST;
	if (kind < uint32_t(RecordKind::FIELD) || kind > uint32_t(RecordKind::END) || size == 0 || size > size_most) {
		return end("is damaged at the head of " + name, true);
	}
	if (rest.size() < packed_size) {
		return end("was cut off within " + name);
	}
	const std::span<const uint8_t> packed = rest.first(packed_size);
	RecordPart part{ RecordKind(kind), std::vector<uint8_t>(size) };
	if (checksum(packed) != get_u32(_bytes, _at + 12) || !p_codec.unpack(packed, part.bytes)) {
		return end("is damaged in " + name, true);
	}
	_at += PART_HEADER_BYTES + packed_size;
	_parts++;
	if (part.kind == RecordKind::END) {
		_is_complete = true;
		return end(std::string(part.bytes.begin(), part.bytes.end()));
	}
	return part;
}

} // namespace grass
