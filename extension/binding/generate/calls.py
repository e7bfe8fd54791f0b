# SPDX-License-Identifier: MIT
"""The text of a C++ function that passes its parameters through the C interface and returns what comes back."""

from generate.api import guard


class Function:
	"""One method of the dump: its Type'd parameters and result. None of them may be unknown (see known())."""

	def __init__(self, api, entry):
		self.name = entry["name"]
		self.cpp_name = guard(entry["name"])
		self.hash = entry.get("hash", 0)
		self.const = entry.get("is_const", False)
		self.static = entry.get("is_static", False)
		self.vararg = entry.get("is_vararg", False)
		self.virtual = entry.get("is_virtual", False)
		result = entry.get("return_value") or ({"type": entry["return_type"]} if "return_type" in entry else None)
		self.result = api.type(result["type"], result.get("meta")) if result else None
		self.arguments = []
		self._known = result is None or self.result is not None
		for argument in entry.get("arguments", []):
			kind = api.type(argument["type"], argument.get("meta"))
			self._known = self._known and kind is not None
			default = argument.get("default_value")
			if kind is not None and default is not None:
				default = api.default(kind, default)
			self.arguments.append((kind, "p_" + argument["name"], default))

	def known(self):
		"""Returns whether the binding knows every type in it."""
		return self._known

	def parameters(self, defaults):
		"""Returns the parameter list, with or without default values."""
		parts = []
		for kind, name, default in self.arguments:
			parts.append(kind.declare(name) + (" = " + default if defaults and default is not None else ""))
		return ", ".join(parts)

	def result_text(self):
		return self.result.result() if self.result else "void "

	def types(self):
		return [kind for kind, _, _ in self.arguments] + ([self.result] if self.result else [])

	def body(self, call):
		"""Returns the lines of the body; call(arguments, count, result) gives the statement that performs the call."""
		lines, places = [], []
		for kind, name, _ in self.arguments:
			local = "value_of_" + name
			if kind.kind == "int" and not kind.name.endswith("int64_t") or kind.kind == "enum":
				lines.append("const int64_t %s = static_cast<int64_t>(%s);" % (local, name))
			elif kind.kind == "float" and kind.name == "float":
				lines.append("const double %s = %s;" % (local, name))
			elif kind.kind == "object":
				lines.append("GodotObject *const %s = %s ? %s->_owner : nullptr;" % (local, name, name))
			elif kind.kind == "ref":
				lines.append("GodotObject *const %s = %s.is_valid() ? %s->_owner : nullptr;" % (local, name, name))
			else:
				local = name
			places.append("&" + local)
		if places:
			lines.append("const GDExtensionConstTypePtr arguments[] = { %s };" % ", ".join(places))
		arguments = "arguments" if places else "nullptr"
		if not self.result:
			return lines + [call(arguments, len(places), "nullptr")]
		declare, give = self.returned()
		return lines + [declare, call(arguments, len(places), "&result"), give]

	def returned(self):
		"""Returns the declaration of the result's storage and the statement that returns it."""
		kind, name = self.result.kind, self.result.name
		if kind == "bool":
			return "bool result = false;", "return result;"
		if kind == "int":
			return "int64_t result = 0;", "return static_cast<%s>(result);" % name if name != "int64_t" else "return result;"
		if kind == "float":
			return "double result = 0.0;", "return static_cast<float>(result);" if name == "float" else "return result;"
		if kind == "enum":
			return "int64_t result = 0;", "return static_cast<%s>(result);" % name
		if kind == "array":
			return "Array result;", "return %s(result);" % name
		if kind == "object":
			return "GodotObject *result = nullptr;", "return static_cast<%s>(internal::get_object_instance_binding(result));" % name
		if kind == "ref":
			return (
				"GodotObject *result = nullptr;",
				"return %s::_gde_internal_constructor(internal::get_object_instance_binding(result));" % name,
			)
		return name + " result;", "return result;"


def definition(head, body):
	"""Returns a function definition."""
	return "%s {\n%s\n}\n" % (head, "\n".join("\t" + line for line in body))
