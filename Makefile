# Scanshade. Two commands are enough to start: `make demo` and `make test`. `make help` lists all.

config ?= release
BUILD  := build/$(config)
MAKEFLAGS += --no-print-directory
JOBS   ?= $(shell nproc 2>/dev/null || echo 2)

# ---- flags ---------------------------------------------------------------------------------------
# No -march (instruction sets are chosen at run time), no -ffast-math, no contraction: the same bits
# everywhere.
CXXFLAGS_COMMON := -std=c++20 -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion \
                   -ffp-contract=off -fno-math-errno -Wno-psabi -MD -MP -Iinclude -Isrc -Itests -I$(BUILD)/gen
CXXFLAGS_release := -O2
CXXFLAGS_debug   := -O0 -g
CXXFLAGS_asan    := -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all \
                    -fno-omit-frame-pointer
ifeq ($(CXXFLAGS_$(config)),)
$(error config=$(config) is unknown; use release, debug or asan)
endif
ALL_CXXFLAGS = $(CXXFLAGS_COMMON) $(CXXFLAGS_$(config)) $(CXXFLAGS)
SDL_CFLAGS = $(shell pkg-config --cflags sdl2 2>/dev/null)
SDL_LIBS   = $(shell pkg-config --libs sdl2 2>/dev/null || echo -lSDL2)
LIBS := -lfmt -lhwy

-include Makefile.local

# ---- files ---------------------------------------------------------------------------------------
LIB_SOURCES    := $(filter-out src/cli/% src/viewer/%,$(wildcard src/*/*.cpp))
CLI_SOURCES    := $(wildcard src/cli/*.cpp)
# The viewer takes its options, errors and exit status from the same files.
VIEWER_SOURCES := $(wildcard src/viewer/*.cpp) src/cli/options.cpp src/cli/console.cpp
TEST_SOURCES   := $(wildcard tests/*.cpp tests/*/*.cpp)
object = $(patsubst %.cpp,$(BUILD)/obj/%.o,$(1))

LIB    := $(BUILD)/libscanshade.a
CLI    := $(BUILD)/scanshade
VIEWER := $(BUILD)/scanshade-view
TESTS  := $(BUILD)/scanshade-tests

.DEFAULT_GOAL := all
.PHONY: all
all: $(CLI) $(VIEWER)  ## build both programs into build/$(config)/

$(BUILD)/obj/src/viewer/%.o $(BUILD)/obj/tests/viewer/%.o: ALL_CXXFLAGS += $(SDL_CFLAGS)

# Tests of the command line run the program that was built beside them.
$(BUILD)/obj/tests/cli/%.o: ALL_CXXFLAGS += -DSCANSHADE_BINARY='"$(abspath $(CLI))"'

$(BUILD)/obj/%.o: %.cpp | $(BUILD)/gen/brdf_models.inc
	@mkdir -p $(@D)
	@echo "  CXX  $<"
	@$(CXX) $(ALL_CXXFLAGS) -c $< -o $@

# The registry of reflection models is the list of files that define one.
MODEL_FILES = $(shell grep -l '^#define SCANSHADE_MODEL ' src/brdf/*.cpp 2>/dev/null)
$(BUILD)/gen/brdf_models.inc: $(wildcard src/brdf/*.cpp)
	@mkdir -p $(@D)
	@sed -n 's/^#define SCANSHADE_MODEL \(.*\)/MODEL(\1)/p' $(MODEL_FILES) > $@

$(LIB): $(call object,$(LIB_SOURCES))
	@rm -f $@ && ar rcs $@ $^
$(CLI): $(call object,$(CLI_SOURCES)) $(LIB)
	@echo "  LINK $@"
	@$(CXX) $(ALL_CXXFLAGS) $^ -o $@ $(LIBS)
$(VIEWER): $(call object,$(VIEWER_SOURCES)) $(LIB)
	@echo "  LINK $@"
	@$(CXX) $(ALL_CXXFLAGS) $^ -o $@ $(LIBS) $(SDL_LIBS)
$(TESTS): $(call object,$(TEST_SOURCES)) $(LIB) | $(CLI)
	@echo "  LINK $@"
	@$(CXX) $(ALL_CXXFLAGS) $^ -o $@ $(LIBS)

-include $(patsubst %.o,%.d,$(call object,$(LIB_SOURCES) $(CLI_SOURCES) $(VIEWER_SOURCES) $(TEST_SOURCES)))

.PHONY: tests
tests: $(TESTS)

.PHONY: clean
clean:  ## remove everything that was built
	rm -rf build
