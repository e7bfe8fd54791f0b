// SPDX-License-Identifier: MIT
// Objects: who owns them, how many references they have, and what is left when they are gone.
#include "tests.h"

#include "probe.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/builtin_types.hpp>

using namespace godot;

TEST_CASE("every Ref counts one, and so does a Variant") {
	Ref<Image> image;
	CHECK((image.is_null()));
	image.instantiate();
	CHECK((image->get_reference_count() == 1));
	{
		const Ref<Image> second = image;
		const Ref<Resource> base = image;
		const Variant held = image;
		CHECK((image->get_reference_count() == 4));
		const Ref<Image> again = held;
		CHECK((again == image && image->get_reference_count() == 5));
	}
	CHECK((image->get_reference_count() == 1));
	Ref<Image> moved = std::move(image);
	CHECK((image.is_null() && moved->get_reference_count() == 1));
	const uint64_t id = moved->get_instance_id();
	moved.unref();
	CHECK((ObjectDB::get_instance(id) == nullptr));
}

TEST_CASE("a Ref of another class is null") {
	Ref<Probe> probe;
	probe.instantiate();
	const Ref<Resource> base = probe;
	CHECK((Ref<Image>(base).is_null()));
	CHECK((Ref<Probe>(base) == probe));
	CHECK((probe->get_reference_count() == 2));
}

TEST_CASE("an object has one wrapper as long as it lives, and none after") {
	Node3D *node = memnew(Node3D);
	const uint64_t id = node->get_instance_id();
	const Variant held = node;
	CHECK((ObjectDB::get_instance(id) == node));
	CHECK((held.get_validated_object() == node));
	CHECK((Object::cast_to<Node>(ObjectDB::get_instance(id)) == node));
	CHECK((Object::cast_to<Image>(ObjectDB::get_instance(id)) == nullptr));
	memdelete(node);
	CHECK((ObjectDB::get_instance(id) == nullptr));
	CHECK((held.get_validated_object() == nullptr));
}

TEST_CASE("a class that the binding does not know is its nearest ancestor") {
	const Variant made = ClassDBSingleton::get_singleton()->instantiate("Marker3D");
	Object *marker = made.get_validated_object();
	CHECK((Object::cast_to<Node3D>(marker) != nullptr));
	CHECK((marker && marker->get_class() == "Marker3D"));
	memdelete(marker);
}

TEST_CASE("a callable of a method is called with arguments, and is invalid when its object is gone") {
	Ref<Probe> probe;
	probe.instantiate();
	const Callable callable = callable_mp(probe.ptr(), &Probe::set_number);
	CHECK((callable.is_valid()));
	callable.call(21);
	CHECK((probe->get_number() == 21));
	const Array arguments = Array::make(4);
	callable.callv(arguments);
	CHECK((probe->get_number() == 4));
	probe.unref();
	CHECK((!callable.is_valid()));
}

int doubled(int p_number) {
	return 2 * p_number;
}

TEST_CASE("a callable of a function without an object is called, and equals another of the same function") {
	const Callable callable = callable_mp_static(&doubled);
	CHECK((callable.is_valid()));
	CHECK((int(callable.call(21)) == 42));
	CHECK((callable == callable_mp_static(&doubled)));
}

TEST_CASE("a method of the engine gets and gives objects, texts and lists") {
	Node *parent = memnew(Node);
	Node3D *child = memnew(Node3D);
	child->set_name("Child");
	parent->add_child(child);
	CHECK((parent->get_child_count() == 1));
	CHECK((parent->get_node<Node3D>(NodePath("Child")) == child));
	const TypedArray<Node> found = parent->find_children("*", "Node3D", true, false);
	CHECK((found.size() == 1 && Object::cast_to<Node3D>(found[0].get_validated_object()) == child));
	const uint64_t id = child->get_instance_id();
	memdelete(parent);
	CHECK((ObjectDB::get_instance(id) == nullptr));
}
