// SPDX-License-Identifier: MIT
// Makes compute pipelines with a driver's compiler, which needs no card, and prints what the compiler says of each.
//
//     pipelines LIST
//
// A line of LIST: a name without spaces, a SPIR-V file, the values of specialization constants 0 and 1, and what is bound, such as
// `4:b 6:t 7:i` (b: buffer, u: uniforms, i: image, t: texture with a sampler, p: without, s: sampler). Prints
// `NAME<tab>STATISTIC<tab>VALUE`; tools/driver_tools.py reads that.
#include <vulkan/vulkan.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST_BINDINGS = 64, MOST_EXECUTABLES = 8, MOST_STATISTICS = 64, MOST_NAME = 128, MOST_PATH = 1024, MOST_PUSHED = 128 };

static const char *const STATISTICS = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;

typedef struct {
	char name[MOST_NAME], file[MOST_PATH];
	uint32_t constants[2];
	VkDescriptorSetLayoutBinding bindings[MOST_BINDINGS];
	uint32_t binding_count;
} Job;

static void check(VkResult p_result, const char *p_what) {
	if (p_result != VK_SUCCESS) {
		fprintf(stderr, "%s failed: VkResult %d\n", p_what, p_result);
		exit(1);
	}
}

static double processor_seconds(void) {
	struct timespec time;
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
	return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

static VkDescriptorType type_of(char p_letter) {
	switch (p_letter) {
		case 'b':
			return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
		case 'i':
			return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
		case 'u':
			return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
		case 'p':
			return VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
		case 's':
			return VK_DESCRIPTOR_TYPE_SAMPLER;
		default:
			return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
	}
}

// Returns whether p_line is a job.
static int read_job(const char *p_line, Job *r_job) {
	int used = 0;
	memset(r_job, 0, sizeof *r_job);
	if (sscanf(p_line, "%127s %1023s %u %u%n", r_job->name, r_job->file, &r_job->constants[0], &r_job->constants[1], &used) != 4) {
		return 0;
	}
	uint32_t number = 0;
	char letter = 0;
	for (int step = 0; r_job->binding_count < MOST_BINDINGS && sscanf(p_line + used, " %u:%c%n", &number, &letter, &step) == 2;
			used += step) {
		VkDescriptorSetLayoutBinding *binding = &r_job->bindings[r_job->binding_count++];
		binding->binding = number;
		binding->descriptorType = type_of(letter);
		binding->descriptorCount = 1;
		binding->stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
	}
	return 1;
}

// The caller frees it.
static uint32_t *read_code(const char *p_path, size_t *r_size) {
	FILE *file = fopen(p_path, "rb");
	if (!file || fseek(file, 0, SEEK_END) != 0) {
		fprintf(stderr, "%s cannot be read\n", p_path);
		exit(1);
	}
	*r_size = (size_t)ftell(file);
	rewind(file);
	uint32_t *code = malloc(*r_size);
	if (!code || fread(code, 1, *r_size, file) != *r_size) {
		fprintf(stderr, "%s cannot be read\n", p_path);
		exit(1);
	}
	fclose(file);
	return code;
}

static VkDevice make_device(VkInstance *r_instance) {
	const VkApplicationInfo application = { .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_1 };
	const VkInstanceCreateInfo instance_info = { .sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &application };
	check(vkCreateInstance(&instance_info, NULL, r_instance), "vkCreateInstance");

	uint32_t count = 1;
	VkPhysicalDevice card = VK_NULL_HANDLE;
	const VkResult found = vkEnumeratePhysicalDevices(*r_instance, &count, &card);
	if (count == 0 || (found != VK_SUCCESS && found != VK_INCOMPLETE)) {
		fprintf(stderr, "The driver offers no device: VkResult %d\n", found);
		exit(1);
	}
	VkPhysicalDeviceProperties properties;
	vkGetPhysicalDeviceProperties(card, &properties);
	printf("device\tname\t%s\n", properties.deviceName);

	const float priority = 1.0F;
	const VkDeviceQueueCreateInfo queue = {
		.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority
	};
	VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR features = {
		.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR, .pipelineExecutableInfo = VK_TRUE
	};
	const VkDeviceCreateInfo device_info = { .sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
		.pNext = &features,
		.queueCreateInfoCount = 1,
		.pQueueCreateInfos = &queue,
		.enabledExtensionCount = 1,
		.ppEnabledExtensionNames = &STATISTICS };
	VkDevice device = VK_NULL_HANDLE;
	check(vkCreateDevice(card, &device_info, NULL, &device), "vkCreateDevice");
	return device;
}

static void print_statistics(VkDevice p_device, VkPipeline p_pipeline, const char *p_name) {
	const PFN_vkGetPipelineExecutablePropertiesKHR get_properties =
			(PFN_vkGetPipelineExecutablePropertiesKHR)vkGetDeviceProcAddr(p_device, "vkGetPipelineExecutablePropertiesKHR");
	const PFN_vkGetPipelineExecutableStatisticsKHR get_statistics =
			(PFN_vkGetPipelineExecutableStatisticsKHR)vkGetDeviceProcAddr(p_device, "vkGetPipelineExecutableStatisticsKHR");
	const VkPipelineInfoKHR pipeline = { .sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, .pipeline = p_pipeline };
	VkPipelineExecutablePropertiesKHR executables[MOST_EXECUTABLES] = { 0 };
	for (int i = 0; i < MOST_EXECUTABLES; i++) {
		executables[i].sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR;
	}
	uint32_t executable_count = MOST_EXECUTABLES;
	check(get_properties(p_device, &pipeline, &executable_count, executables), "vkGetPipelineExecutablePropertiesKHR");

	for (uint32_t i = 0; i < executable_count; i++) {
		const VkPipelineExecutableInfoKHR executable = {
			.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR, .pipeline = p_pipeline, .executableIndex = i
		};
		VkPipelineExecutableStatisticKHR statistics[MOST_STATISTICS] = { 0 };
		for (int s = 0; s < MOST_STATISTICS; s++) {
			statistics[s].sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
		}
		uint32_t count = MOST_STATISTICS;
		check(get_statistics(p_device, &executable, &count, statistics), "vkGetPipelineExecutableStatisticsKHR");
		for (uint32_t s = 0; s < count; s++) {
			if (statistics[s].format != VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_FLOAT64_KHR) { // the others are 64 bits wide as well
				printf("%s\t%s\t%lld\n", p_name, statistics[s].name, (long long)statistics[s].value.i64);
			}
		}
	}
}

static void compile(VkDevice p_device, const Job *p_job) {
	size_t size = 0;
	uint32_t *code = read_code(p_job->file, &size);
	const VkDescriptorSetLayoutCreateInfo set_info = {
		.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = p_job->binding_count, .pBindings = p_job->bindings
	};
	VkDescriptorSetLayout set = VK_NULL_HANDLE;
	check(vkCreateDescriptorSetLayout(p_device, &set_info, NULL, &set), "vkCreateDescriptorSetLayout");
	const VkPushConstantRange pushed = { VK_SHADER_STAGE_COMPUTE_BIT, 0, MOST_PUSHED };
	const VkPipelineLayoutCreateInfo layout_info = { .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
		.setLayoutCount = 1,
		.pSetLayouts = &set,
		.pushConstantRangeCount = 1,
		.pPushConstantRanges = &pushed };
	VkPipelineLayout layout = VK_NULL_HANDLE;
	check(vkCreatePipelineLayout(p_device, &layout_info, NULL, &layout), "vkCreatePipelineLayout");

	const double begin = processor_seconds();
	const VkShaderModuleCreateInfo module_info = { .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = size, .pCode = code };
	VkShaderModule module = VK_NULL_HANDLE;
	check(vkCreateShaderModule(p_device, &module_info, NULL, &module), "vkCreateShaderModule");
	const VkSpecializationMapEntry entries[2] = { { 0, 0, 4 }, { 1, 4, 4 } }; // constants that a pass lacks are passed over
	const VkSpecializationInfo constants = { 2, entries, sizeof p_job->constants, p_job->constants };
	const VkComputePipelineCreateInfo pipeline_info = { .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
		.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR,
		.stage = { .sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
				.stage = VK_SHADER_STAGE_COMPUTE_BIT,
				.module = module,
				.pName = "main",
				.pSpecializationInfo = &constants },
		.layout = layout };
	VkPipeline pipeline = VK_NULL_HANDLE;
	const VkResult result = vkCreateComputePipelines(p_device, VK_NULL_HANDLE, 1, &pipeline_info, NULL, &pipeline);
	if (result == VK_SUCCESS) {
		printf("%s\tseconds\t%.2f\n", p_job->name, processor_seconds() - begin);
		print_statistics(p_device, pipeline, p_job->name);
	} else {
		printf("%s\trefused\t%d\n", p_job->name, result);
	}
	fflush(stdout);
	vkDestroyPipeline(p_device, pipeline, NULL);
	vkDestroyShaderModule(p_device, module, NULL);
	vkDestroyPipelineLayout(p_device, layout, NULL);
	vkDestroyDescriptorSetLayout(p_device, set, NULL);
	free(code);
}

int main(int argc, char **argv) {
	FILE *list = argc == 2 ? fopen(argv[1], "r") : NULL;
	if (!list) {
		fprintf(stderr, "usage: pipelines LIST\n");
		return 2;
	}
	VkInstance instance = VK_NULL_HANDLE;
	const VkDevice device = make_device(&instance);
	char line[4096];
	Job job;
	while (fgets(line, sizeof line, list)) {
		if (read_job(line, &job)) {
			compile(device, &job);
		}
	}
	fclose(list);
	vkDestroyDevice(device, NULL);
	vkDestroyInstance(instance, NULL);
	return 0;
}
