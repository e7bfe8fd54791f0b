// SPDX-License-Identifier: MIT
// Moves a tile of blades by their strains for 600 steps, with core/solver/strain and with a Vulkan device's pass, under loads that come and
// go. Prints how far the knots of the two are apart at worst, blade lengths; with that the farthest that one is from rest.
//
//     strain_parity SPIRV
#include <vulkan/vulkan.h>

#include "core/bodies/collider.cpp"
#include "core/solver/blade_order.cpp"
#include "core/solver/section.cpp"
#include "core/solver/solver_params.cpp"
#include "core/solver/step_scalar.cpp"
#include "core/solver/strain/basis.cpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

using namespace grass;

namespace {

constexpr int BLADES = GRASS_BLADES_PER_TILE;
constexpr float LENGTH = 0.5f; // metres
constexpr int KNOT_FLOATS = 3 * GRASS_FREE_KNOTS * BLADES; // of a half of the pool

void check(VkResult p_result, const char *p_what) {
	if (p_result != VK_SUCCESS) {
		std::fprintf(stderr, "%s failed: VkResult %d\n", p_what, p_result);
		std::exit(1);
	}
}

// Every handle lives as long as the program.
struct Device {
	VkPhysicalDevice physical{};
	VkDevice device{};
	VkQueue queue{};

	Device() {
		VkApplicationInfo application{ VK_STRUCTURE_TYPE_APPLICATION_INFO };
		application.apiVersion = VK_API_VERSION_1_1;
		VkInstanceCreateInfo made{ VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO };
		made.pApplicationInfo = &application;
		VkInstance instance;
		check(vkCreateInstance(&made, nullptr, &instance), "vkCreateInstance");
		uint32_t count = 1;
		const VkResult found = vkEnumeratePhysicalDevices(instance, &count, &physical);
		check(found == VK_INCOMPLETE ? VK_SUCCESS : found, "vkEnumeratePhysicalDevices");
		const float priority = 1.0f;
		VkDeviceQueueCreateInfo queues{ VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO };
		queues.queueCount = 1;
		queues.pQueuePriorities = &priority;
		VkDeviceCreateInfo of{ VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO };
		of.queueCreateInfoCount = 1;
		of.pQueueCreateInfos = &queues;
		check(vkCreateDevice(physical, &of, nullptr, &device), "vkCreateDevice");
		vkGetDeviceQueue(device, 0, 0, &queue);
	}
	VkDeviceMemory allocate(const VkMemoryRequirements &p_wanted) const {
		constexpr VkMemoryPropertyFlags SHARED = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
		VkPhysicalDeviceMemoryProperties has;
		vkGetPhysicalDeviceMemoryProperties(physical, &has);
		VkMemoryAllocateInfo of{ VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO };
		of.allocationSize = p_wanted.size;
		while (!(p_wanted.memoryTypeBits >> of.memoryTypeIndex & 1u) ||
				(has.memoryTypes[of.memoryTypeIndex].propertyFlags & SHARED) != SHARED) {
			of.memoryTypeIndex++;
		}
		VkDeviceMemory memory;
		check(vkAllocateMemory(device, &of, nullptr, &memory), "vkAllocateMemory");
		return memory;
	}
	void *map(VkDeviceMemory p_memory) const {
		void *place;
		check(vkMapMemory(device, p_memory, 0, VK_WHOLE_SIZE, 0, &place), "vkMapMemory");
		return place;
	}
};

// What the pass has bound, in memory that both sides see.
struct Bound {
	VkDescriptorType type;
	VkBuffer buffer{};
	VkImage image{};
	VkImageView view{};
	float *numbers;

	Bound(const Device &p_device, size_t p_floats) : type(VK_DESCRIPTOR_TYPE_STORAGE_BUFFER) {
		VkBufferCreateInfo of{ VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO };
		of.size = p_floats * sizeof(float);
		of.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
		check(vkCreateBuffer(p_device.device, &of, nullptr, &buffer), "vkCreateBuffer");
		VkMemoryRequirements wanted;
		vkGetBufferMemoryRequirements(p_device.device, buffer, &wanted);
		const VkDeviceMemory memory = p_device.allocate(wanted);
		check(vkBindBufferMemory(p_device.device, buffer, memory, 0), "vkBindBufferMemory");
		numbers = static_cast<float *>(p_device.map(memory));
		std::memset(numbers, 0, of.size);
	}
	// A texture of one row of 16 knots of each blade.
	Bound(const Device &p_device, VkFormat p_format, VkDescriptorType p_type) : type(p_type) {
		VkImageCreateInfo of{ VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO };
		of.imageType = VK_IMAGE_TYPE_2D;
		of.format = p_format;
		of.extent = { uint32_t(GRASS_KNOTS * BLADES), 1, 1 };
		of.mipLevels = of.arrayLayers = 1;
		of.samples = VK_SAMPLE_COUNT_1_BIT;
		of.tiling = VK_IMAGE_TILING_LINEAR;
		of.usage = p_type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE ? VK_IMAGE_USAGE_STORAGE_BIT : VK_IMAGE_USAGE_SAMPLED_BIT;
		of.initialLayout = VK_IMAGE_LAYOUT_PREINITIALIZED;
		check(vkCreateImage(p_device.device, &of, nullptr, &image), "vkCreateImage");
		VkMemoryRequirements wanted;
		vkGetImageMemoryRequirements(p_device.device, image, &wanted);
		const VkDeviceMemory memory = p_device.allocate(wanted);
		check(vkBindImageMemory(p_device.device, image, memory, 0), "vkBindImageMemory");
		numbers = static_cast<float *>(p_device.map(memory));
		VkImageViewCreateInfo seen{ VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO };
		seen.image = image;
		seen.viewType = VK_IMAGE_VIEW_TYPE_2D;
		seen.format = p_format;
		seen.subresourceRange = { VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1 };
		check(vkCreateImageView(p_device.device, &seen, nullptr, &view), "vkCreateImageView");
	}
};

// The pass with what it reads and writes.
struct Pass {
	Device device;
	Bound slots{ device, sizeof(GrassSlot) / sizeof(float) }, knots{ device, size_t(2 * KNOT_FLOATS) }, halves{ device, 1 },
			energy{ device, 4 }, growth{ device, 4 * BLADES }, section{ device, sizeof(StrainSection<float>) / sizeof(float) },
			twists{ device, size_t((GRASS_LENGTH_ROW + 1) * BLADES) }, forces{ device, sizeof(GrassForce) / sizeof(float) },
			patch{ device, VK_FORMAT_R32G32B32A32_SFLOAT, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER },
			pool{ device, VK_FORMAT_R16G16B16A16_SFLOAT, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE };
	VkDescriptorSetLayout set_layout{};
	VkPipelineLayout layout{};
	VkPipeline pipeline{};
	VkDescriptorSet set{};
	VkCommandBuffer commands{};
	bool is_first = true;

	std::vector<std::pair<uint32_t, const Bound *>> bound() const {
		return { { GRASS_BINDING_SLOTS, &slots }, { GRASS_BINDING_KNOTS, &knots }, { GRASS_BINDING_HALVES, &halves },
			{ GRASS_BINDING_PATCH, &patch }, { GRASS_BINDING_POOL_TEXTURE, &pool }, { GRASS_BINDING_ENERGY, &energy },
			{ GRASS_BINDING_GROWTH, &growth }, { GRASS_BINDING_SECTIONS, &section }, { GRASS_BINDING_TWISTS, &twists },
			{ GRASS_BINDING_FORCES, &forces } };
	}
	void make_layout() {
		std::vector<VkDescriptorSetLayoutBinding> bindings;
		for (const auto &[number, what] : bound()) {
			bindings.push_back({ number, what->type, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr });
		}
		VkDescriptorSetLayoutCreateInfo of{ VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO };
		of.bindingCount = uint32_t(bindings.size());
		of.pBindings = bindings.data();
		check(vkCreateDescriptorSetLayout(device.device, &of, nullptr, &set_layout), "vkCreateDescriptorSetLayout");
		const VkPushConstantRange pushed{ VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(GrassStep) };
		VkPipelineLayoutCreateInfo all{ VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO };
		all.setLayoutCount = all.pushConstantRangeCount = 1;
		all.pSetLayouts = &set_layout;
		all.pPushConstantRanges = &pushed;
		check(vkCreatePipelineLayout(device.device, &all, nullptr, &layout), "vkCreatePipelineLayout");
	}
	void make_set() {
		const VkDescriptorPoolSize sizes[] = { { VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 16 }, { patch.type, 1 }, { pool.type, 1 } };
		VkDescriptorPoolCreateInfo of{ VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO };
		of.maxSets = 1;
		of.poolSizeCount = 3;
		of.pPoolSizes = sizes;
		VkDescriptorPool descriptors;
		check(vkCreateDescriptorPool(device.device, &of, nullptr, &descriptors), "vkCreateDescriptorPool");
		VkDescriptorSetAllocateInfo one{ VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO };
		one.descriptorPool = descriptors;
		one.descriptorSetCount = 1;
		one.pSetLayouts = &set_layout;
		check(vkAllocateDescriptorSets(device.device, &one, &set), "vkAllocateDescriptorSets");
		const VkSamplerCreateInfo plain{ VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO };
		VkSampler sampler;
		check(vkCreateSampler(device.device, &plain, nullptr, &sampler), "vkCreateSampler");
		for (const auto &[number, what] : bound()) {
			const VkDescriptorBufferInfo buffer{ what->buffer, 0, VK_WHOLE_SIZE };
			const VkDescriptorImageInfo image{ sampler, what->view, VK_IMAGE_LAYOUT_GENERAL };
			VkWriteDescriptorSet write{ VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET };
			write.dstSet = set;
			write.dstBinding = number;
			write.descriptorCount = 1;
			write.descriptorType = what->type;
			write.pBufferInfo = &buffer;
			write.pImageInfo = &image;
			vkUpdateDescriptorSets(device.device, 1, &write, 0, nullptr);
		}
	}
	explicit Pass(const char *p_spirv) {
		make_layout();
		make_set();
		std::ifstream file(p_spirv, std::ios::binary);
		const std::string code((std::istreambuf_iterator<char>(file)), {});
		VkShaderModuleCreateInfo of{ VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO };
		of.codeSize = code.size();
		of.pCode = reinterpret_cast<const uint32_t *>(code.data());
		VkComputePipelineCreateInfo made{ VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO };
		made.stage = { VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO };
		made.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
		made.stage.pName = "main";
		check(vkCreateShaderModule(device.device, &of, nullptr, &made.stage.module), "vkCreateShaderModule");
		made.layout = layout;
		check(vkCreateComputePipelines(device.device, nullptr, 1, &made, nullptr, &pipeline), "vkCreateComputePipelines");
		VkCommandPoolCreateInfo reused{ VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO };
		reused.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
		VkCommandBufferAllocateInfo one{ VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO };
		check(vkCreateCommandPool(device.device, &reused, nullptr, &one.commandPool), "vkCreateCommandPool");
		one.commandBufferCount = 1;
		check(vkAllocateCommandBuffers(device.device, &one, &commands), "vkAllocateCommandBuffers");
	}
	void show_images() {
		for (const Bound *texture : { &patch, &pool }) {
			VkImageMemoryBarrier barrier{ VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER };
			barrier.srcAccessMask = VK_ACCESS_HOST_WRITE_BIT;
			barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
			barrier.oldLayout = VK_IMAGE_LAYOUT_PREINITIALIZED;
			barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
			barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
			barrier.image = texture->image;
			barrier.subresourceRange = { VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1 };
			vkCmdPipelineBarrier(
					commands, VK_PIPELINE_STAGE_HOST_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 0, nullptr, 0, nullptr, 1, &barrier);
		}
	}
	void step(const GrassStep &p_step) {
		const VkCommandBufferBeginInfo begin{ VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO };
		check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
		if (is_first) {
			show_images();
			is_first = false;
		}
		vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
		vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, nullptr);
		vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(p_step), &p_step);
		vkCmdDispatch(commands, 1, 1, 1);
		check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
		VkSubmitInfo work{ VK_STRUCTURE_TYPE_SUBMIT_INFO };
		work.commandBufferCount = 1;
		work.pCommandBuffers = &commands;
		check(vkQueueSubmit(device.queue, 1, &work, nullptr), "vkQueueSubmit");
		check(vkQueueWaitIdle(device.queue), "vkQueueWaitIdle");
	}
};

// Blades that lean and curve ever more, each to another side; the same for both.
void grow(TileState &r_tile, Pass &r_pass) {
	const GrassSlot slot{ {}, { 0, 0, 0, GRASS_SLOT_MAPPED }, {}, { 0, BLADES, 1, 0 } };
	std::memcpy(r_pass.slots.numbers, &slot, sizeof(slot));
	for (int b = 0; b < BLADES; b++) {
		const double heading = 0.7 * b, curve = 1.5 * b / BLADES;
		r_pass.growth.numbers[4 * b] = 1.0f;
		r_pass.patch.numbers[4 * b + 2] = float(heading);
		r_tile.width[0][b] = float(std::cos(double(float(heading))));
		r_tile.width[1][b] = float(std::sin(double(float(heading))));
		double place[3] = { 0.0, 0.0, 0.0 };
		for (int k = 1; k < GRASS_KNOTS; k++) {
			const double size = double(LENGTH) * segment_share(k - 1), lean = curve * (knot_share(k) - 0.5 * segment_share(k - 1));
			const double ways[] = { std::sin(lean) * std::cos(heading + 2.0), std::cos(lean), std::sin(lean) * std::sin(heading + 2.0) };
			for (int c = 0; c < 3; c++) {
				place[c] += size * ways[c];
				const float rest = r_tile.rest[c][k][b] = r_pass.patch.numbers[4 * (k * BLADES + b) + c] = float(place[c]);
				if (k >= GRASS_CLAMPED_KNOTS) {
					const int free = k - GRASS_CLAMPED_KNOTS, at = (c * GRASS_FREE_KNOTS + free) * BLADES + b;
					r_tile.knots[c][free][b] = r_tile.before[c][free][b] = rest;
					r_pass.knots.numbers[at] = r_pass.knots.numbers[KNOT_FLOATS + at] = rest;
				}
			}
		}
	}
}

} // namespace

int main(int p_count, char **p_arguments) {
	if (p_count != 2) {
		return 2;
	}
	Pass pass(p_arguments[1]);
	const auto tile = std::make_unique<TileState>();
	grow(*tile, pass);
	const StrainSection<float> section = make_strain_section(TAPER.initial, WIDTH_TO_THICKNESS.initial);
	std::memcpy(pass.section.numbers, &section, sizeof(section));
	tile->sections = &section;
	SolverParams params;
	params.damping_ratio = 0.1;
	StepClock clock;
	float apart = 0.0f, farthest = 0.0f;
	for (int i = 0; i < 600; i++) {
		const double load = i < 450 ? 14.0 * sine(i / 12.0) + (i % 40 < 12 ? 9.0 : 0.0) : 0.0; // m/s^2
		params.load[0] = 0.8 * load;
		params.load[1] = -0.1 * load;
		params.load[2] = 0.5 * load;
		GrassStep step = clock.advance(params, 1.0 / 60.0);
		step.field.w = float(GRASS_KNOTS);
		step_scalar_float(*tile, { &step, 1 }, 0.0f, {});
		step.contact.w = 0.0f; // the first workgroup
		pass.step(step);
		uint32_t half;
		std::memcpy(&half, pass.halves.numbers, sizeof(half));
		for (int i = 0; i < KNOT_FLOATS; i++) {
			const float here = (&tile->knots[0][0][0])[i],
						rest = tile->rest[i / (GRASS_FREE_KNOTS * BLADES)][GRASS_CLAMPED_KNOTS + i / BLADES % GRASS_FREE_KNOTS][i % BLADES];
			apart = std::max(apart, std::abs(pass.knots.numbers[int(half & 1u) * KNOT_FLOATS + i] - here) / LENGTH);
			farthest = std::max(farthest, std::abs(here - rest) / LENGTH);
		}
	}
	std::printf("%g %g\n", double(apart), double(farthest));
}
