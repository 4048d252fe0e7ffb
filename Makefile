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
                    -fno-omit-frame-pointer -Wno-maybe-uninitialized  # false alarms in Catch
# oneTBB is not instrumented; loops run on threads of the standard library instead.
CXXFLAGS_tsan    := -O1 -g -fsanitize=thread -fno-omit-frame-pointer -DSCANSHADE_STD_THREADS \
                    -Wno-maybe-uninitialized
# Counts of loops on several threads must not get lost, and a branch must not count once for each place
# that its function is inlined into.
CXXFLAGS_coverage := -O1 -g --coverage -fprofile-update=atomic -fno-inline -DSCANSHADE_INLINE=inline \
                     -Wno-maybe-uninitialized
# libFuzzer is clang's. What a file holds must neither overflow nor leak, so everything is watched.
CXXFLAGS_fuzz    := -O1 -g -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all \
                    -fno-omit-frame-pointer
ifeq ($(config),fuzz)
CXX := clang++
endif
ifeq ($(CXXFLAGS_$(config)),)
$(error config=$(config) is unknown; use release, debug, asan, tsan, coverage or fuzz)
endif
ALL_CXXFLAGS = $(CXXFLAGS_COMMON) $(CXXFLAGS_$(config)) $(CXXFLAGS)
SDL_CFLAGS = $(shell pkg-config --cflags sdl2 imgui 2>/dev/null)
SDL_LIBS   = $(shell pkg-config --libs imgui sdl2 2>/dev/null || echo -limgui -lstb -lSDL2)
LIBS := -lfmt -lhwy -lmeshoptimizer -ltbb
export PYTHONDONTWRITEBYTECODE := 1

-include Makefile.local

# ---- files ---------------------------------------------------------------------------------------
LIB_SOURCES    := $(filter-out src/cli/% src/viewer/% $(if $(filter fuzz,$(config)),src/report/%), \
                    $(wildcard src/*/*.cpp src/*/*/*.cpp))
CLI_SOURCES    := $(wildcard src/cli/*.cpp)
# The viewer takes its options, errors and exit status from the same files.
VIEWER_SOURCES := $(wildcard src/viewer/*.cpp) \
                  $(patsubst %,src/cli/%.cpp,options console shipped)
# What tests link of the programs: nothing of it sees SDL.
TESTED_SOURCES := $(patsubst %,src/viewer/%.cpp,actions camera_control files light_control picture \
                    view_edit view_state) src/cli/lettering.cpp
# The benchmark links what the tests do not need; of the programs it takes tables and memory.
BENCH_SOURCES  := $(wildcard tests/bench/*.cpp) $(patsubst %,src/cli/%.cpp,console stats events)
FUZZ_SOURCES   := $(wildcard tests/fuzz/*_fuzz.cpp)
TEST_SOURCES   := $(filter-out $(BENCH_SOURCES) $(FUZZ_SOURCES),$(wildcard tests/*.cpp tests/*/*.cpp))
object = $(patsubst %.cpp,$(BUILD)/obj/%.o,$(1))

LIB    := $(BUILD)/libscanshade.a
CLI    := $(BUILD)/scanshade
VIEWER := $(BUILD)/scanshade-view
TESTS  := $(BUILD)/scanshade-tests
BENCH  := $(BUILD)/scanshade-bench

.DEFAULT_GOAL := all
.PHONY: all
all: $(CLI) $(VIEWER)  ## build both programs into build/$(config)/

$(BUILD)/obj/src/viewer/%.o: ALL_CXXFLAGS += $(SDL_CFLAGS)

# The peers' code gets whatever makes it fastest: the rules of this project's own arithmetic are not
# its rules.
$(BUILD)/obj/tests/bench/embree.o: ALL_CXXFLAGS += -O3
$(BUILD)/obj/tests/bench/packet_shading.o: ALL_CXXFLAGS += -O3 -ffast-math -mprefer-vector-width=512

# The decoder of pictures takes for granted that sums and products of hostile numbers wrap.
$(BUILD)/obj/src/image/png.o: ALL_CXXFLAGS += -fwrapv

# Tests of the programs run those that were built beside them.
$(BUILD)/obj/tests/cli/%.o $(BUILD)/obj/tests/viewer/%.o: ALL_CXXFLAGS += -DSCANSHADE_BINARY='"$(abspath $(CLI))"'

$(BUILD)/obj/%.o: %.cpp | $(BUILD)/gen/brdf_models.inc $(BUILD)/gen/demo.found
	@mkdir -p $(@D)
	@echo "  CXX  $<"
	@$(CXX) $(ALL_CXXFLAGS) -c $< -o $@

# What is missing is said in a sentence, before a compiler says it in pages. Looked for once.
$(call object,$(VIEWER_SOURCES)): | $(BUILD)/gen/viewer.found
$(BUILD)/gen/demo.found:   NEEDS = $(DEMO_NEEDS)
$(BUILD)/gen/viewer.found: NEEDS = $(VIEWER_NEEDS)
$(BUILD)/gen/%.found: Makefile
	@mkdir -p $(@D)
	@CXX='$(CXX)' bash .ci/deps --check $(NEEDS)
	@touch $@

# The registry of reflection models is the list of files that define one.
MODEL_FILES = $(shell grep -l '^#define SCANSHADE_MODEL ' src/brdf/*.cpp 2>/dev/null)
$(BUILD)/gen/brdf_models.inc: $(wildcard src/brdf/*.cpp)
	@mkdir -p $(@D)
	@sed -n 's/^#define SCANSHADE_MODEL \(.*\)/MODEL(\1)/p' $(MODEL_FILES) > $@

# The loops over samples: what inlines and unrolls there pays. GCC copies structs of vectors in halves
# and quarters unless it is told otherwise, and reading what was just written so waits. Nobody reads
# the processor's flags of exceptions: what a branch needs may be computed ahead of it. No bit changes.
WIDE_MOVES := $(shell echo 'int x;' | $(CXX) -mmove-max=512 -mstore-max=512 -x c++ -c -o /dev/null - \
                2>/dev/null && echo -mmove-max=512 -mstore-max=512)
LOOP_FLAGS_release := -O3 -fno-trapping-math $(WIDE_MOVES)
$(call object,$(MODEL_FILES) $(filter-out %/isa.cpp,$(wildcard src/kernels/*.cpp))): \
    ALL_CXXFLAGS += $(LOOP_FLAGS_$(config))

# What reports say about this build. Looked at by every make, written only where it is another, and
# read by one file: a commit does not rebuild the rest.
FACTS := $(BUILD)/gen/build_facts.inc
$(BUILD)/obj/src/report/provenance.o: $(FACTS)
$(FACTS): export BUILD_FLAGS = $(filter-out -I% -M% -W%,$(ALL_CXXFLAGS))$(if $(LOOP_FLAGS_$(config)),; loops $(LOOP_FLAGS_$(config)))
$(FACTS): FORCE
	@mkdir -p $(@D)
	@commit=unknown; \
	if [ "$$(git rev-parse --show-cdup 2>/dev/null || echo none)" = "" ]; then \
	    commit=$$(git describe --always --dirty --abbrev=12 2>/dev/null || echo unknown); fi; \
	{ printf '#define BUILD_COMMIT "%s"\n' "$$commit"; \
	  printf '#define BUILD_FLAGS "%s"\n' "$$(printf %s "$$BUILD_FLAGS" | sed 's/[\\"]/\\&/g')"; } > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@
.PHONY: FORCE
FORCE:

$(LIB): $(call object,$(LIB_SOURCES))
	@rm -f $@ && ar rcs $@ $^
$(CLI): $(call object,$(CLI_SOURCES)) $(LIB)
	@echo "  LINK $@"
	@$(CXX) $(ALL_CXXFLAGS) $^ -o $@ $(LIBS)
$(VIEWER): $(call object,$(VIEWER_SOURCES)) $(LIB)
	@echo "  LINK $@"
	@$(CXX) $(ALL_CXXFLAGS) $^ -o $@ $(LIBS) $(SDL_LIBS)
$(TESTS): $(call object,$(TEST_SOURCES) $(TESTED_SOURCES)) $(LIB) | $(CLI) $(VIEWER)
	@echo "  LINK $@"
	@$(CXX) $(ALL_CXXFLAGS) $^ -o $@ $(LIBS)

# What fuzz targets take of the tests and of the programs.
FUZZ_PARTS := $(patsubst %,tests/support/%.cpp,level_check lit_points random_mesh random_scene \
                scene_check) $(patsubst %,src/cli/%.cpp,console options)
.SECONDARY: $(call object,$(FUZZ_SOURCES))
$(BUILD)/%-fuzz: $(BUILD)/obj/tests/fuzz/%_fuzz.o $(call object,$(FUZZ_PARTS)) $(LIB)
	@echo "  LINK $@"
	@$(CXX) $(ALL_CXXFLAGS) -fsanitize=fuzzer $^ -o $@ $(LIBS)

$(BENCH): $(call object,$(BENCH_SOURCES)) $(LIB)
	@echo "  LINK $@"
	@$(CXX) $(ALL_CXXFLAGS) $^ -o $@ $(LIBS) -lOSMesa -lembree3 -ltbb

-include $(patsubst %.o,%.d,$(call object,$(LIB_SOURCES) $(CLI_SOURCES) $(VIEWER_SOURCES) \
    $(TEST_SOURCES) $(BENCH_SOURCES) $(FUZZ_SOURCES)))

.PHONY: tests
tests: $(TESTS)

# ---- what is needed ------------------------------------------------------------------------------
# Debian package:how it shows where it was installed otherwise (a header, a command or a path).
DEMO_NEEDS := g++:c++ libglm-dev:glm/vec3.hpp libtinyobjloader-dev:tiny_obj_loader.h \
              libstb-dev:stb/stb_image.h libcli11-dev:CLI/CLI.hpp \
              libtomlplusplus-dev:toml++/toml.h nlohmann-json3-dev:nlohmann/json.hpp \
              libfmt-dev:fmt/format.h libhwy-dev:hwy/highway.h \
              libmeshoptimizer-dev:meshoptimizer.h libtbb-dev:tbb/parallel_for.h
VIEWER_NEEDS := libsdl2-dev:SDL2/SDL.h libimgui-dev:imgui/imgui.h
TEST_NEEDS := $(DEMO_NEEDS) $(VIEWER_NEEDS) catch2:catch2/catch.hpp,catch2/catch_all.hpp \
              fonts-dejavu-core:/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf \
              pkg-config:pkg-config python3:python3 clang-format:clang-format xvfb:Xvfb \
              xdotool:xdotool x11-apps:xwd imagemagick:convert \
              libboost-dev:boost/multiprecision/cpp_int.hpp \
              assimp-testmodels:/usr/share/assimp/models gnuplot-nox:gnuplot
BENCH_NEEDS := $(DEMO_NEEDS) libosmesa6-dev:GL/osmesa.h libembree-dev:embree3/rtcore.h
FUZZ_NEEDS := $(TEST_NEEDS) clang:clang++
REPORT_NEEDS := $(DEMO_NEEDS) gnuplot-nox:gnuplot
LINT_NEEDS := $(TEST_NEEDS) $(BENCH_NEEDS) clang:clang++ clang-tidy:clang-tidy cppcheck:cppcheck

.PHONY: deps deps-demo deps-test deps-bench deps-fuzz deps-report deps-lint deps-valgrind
deps: deps-test deps-bench deps-fuzz deps-report deps-lint deps-valgrind  ## install the Debian packages that are missing, for all targets
deps-demo:
	@CXX='$(CXX)' bash .ci/deps $(DEMO_NEEDS)
deps-test:
	@CXX='$(CXX)' bash .ci/deps $(TEST_NEEDS)
deps-bench:
	@CXX='$(CXX)' bash .ci/deps $(BENCH_NEEDS)
deps-fuzz:
	@CXX='$(CXX)' bash .ci/deps $(FUZZ_NEEDS)
deps-report:
	@CXX='$(CXX)' bash .ci/deps $(REPORT_NEEDS)
deps-valgrind:
	@CXX='$(CXX)' bash .ci/deps $(TEST_NEEDS) valgrind:valgrind
deps-lint:
	@CXX='$(CXX)' bash .ci/deps $(LINT_NEEDS)

# Programs are built by a second make, so that packages are there first and all cores are used.
SUBMAKE = $(MAKE) $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(JOBS))

# ---- targets for people --------------------------------------------------------------------------
DEMO_SCENE := models/scenes/teapot.toml

.PHONY: demo
demo: deps-demo  ## draw the teapot into build/demo.png
	@$(SUBMAKE) $(CLI)
	@$(CLI) render $(DEMO_SCENE) -o build/demo.png
	@echo
	@echo 'build/demo.png is $(DEMO_SCENE), lit at every pixel. Try next:'
	@echo '  $(CLI) render $(DEMO_SCENE) --shading gouraud -o build/gouraud.png'
	@echo '  $(CLI) sheet $(DEMO_SCENE) -o build/sheet.png   every shading with every model'
	@echo '  $(CLI) lesson all -o build/lessons                 a booklet on shading: index.html'
	@echo '  $(CLI) --help'
	@echo '  make deps && make && $(CLI) view $(DEMO_SCENE)   in a window'

.PHONY: test
test: deps-test  ## build and run all tests; TAGS=[brdf] runs those of one tag
	@$(SUBMAKE) all tests
	@$(TESTS) $(if $(TAGS),'$(TAGS)')

# The least share of lines and of branches in src/ and include/ that tests must reach, in percent.
COVERED_LINES := 97
COVERED_BRANCHES := 85
.PHONY: coverage
coverage: deps-test  ## all tests with gcov, what they reach by layer, and the floor that must be held
	@find build/coverage -name '*.gcda' -delete 2>/dev/null || true
	@$(MAKE) config=coverage test
	@python3 tests/support/coverage.py build/coverage/obj build/coverage/missed.txt \
	    $(COVERED_LINES) $(COVERED_BRANCHES)

# Memory that was never written is what the sanitizers do not see. Small pictures by the scalar
# renderers, every shading and interpolation, and tests of what reads files.
.PHONY: valgrind
valgrind: deps-valgrind  ## valgrind on small pictures by the scalar renderers and some tests; minutes
	@$(SUBMAKE) all tests
	@CLI=$(CLI) TESTS=$(TESTS) bash tests/support/valgrind.sh

.PHONY: view-speed
view-speed: deps-test  ## how many frames a second the viewer turns the teapot by, at 1280 × 720
	@$(SUBMAKE) all tests
	@$(TESTS) '[.view-speed]'

CELLS ?= all
.PHONY: bench
bench: deps-bench  ## times beside llvmpipe and Embree, in build/bench/; CELLS=quick takes 2 minutes
	@$(SUBMAKE) $(BENCH)
	@$(BENCH) --cells '$(CELLS)' $(if $(MESH),--mesh '$(MESH)') $(if $(CULL:back=),--two-sided) \
	    --commit "$$(git describe --always --dirty 2>/dev/null || echo unknown)" \
	    --build='$(strip $(CXX) $(filter-out -W% -I% -M%,$(CXXFLAGS_COMMON) $(CXXFLAGS_$(config)) $(CXXFLAGS)))'

.PHONY: soak
soak: deps-test  ## N=20000 random scenes from seed FIRST=1 on every instruction set, or on ISA=name
	@$(SUBMAKE) all tests
	@SCANSHADE_SOAK=$(or $(N),20000) SCANSHADE_SOAK_FIRST=$(or $(FIRST),1) \
	    SCANSHADE_SOAK_ISA=$(ISA) $(TESTS) '[.soak]'

# A corpus is what the script makes and what earlier runs found; an input that fails is left in build/fuzz.
FUZZ_TARGETS := $(patsubst tests/fuzz/%_fuzz.cpp,fuzz-%,$(FUZZ_SOURCES))
.PHONY: fuzz $(FUZZ_TARGETS)
fuzz: $(FUZZ_TARGETS)  ## every tests/fuzz/NAME_fuzz.cpp for TIME=60 seconds, by libFuzzer; fuzz-NAME: one
$(FUZZ_TARGETS): fuzz-%: deps-fuzz
	@$(SUBMAKE) config=fuzz build/fuzz/$*-fuzz
	@python3 tests/fuzz/seeds.py $* build/fuzz
	@cd build/fuzz && TMPDIR="$$PWD/tmp" ./$*-fuzz corpus/$* -dict=$*.dict -timeout=60 -close_fd_mask=1 \
	    -max_total_time=$(or $(TIME),60) -print_final_stats=1 -artifact_prefix=$*-

.PHONY: report
report: deps-report  ## all reports, into build/report/: error, plan, speed, stability; takes minutes
	@$(SUBMAKE) $(CLI)
	@$(CLI) report plan -o build/report/plan
	@$(CLI) report speed -o build/report/speed
	@$(CLI) report error -o build/report/error
	@$(CLI) report stability -o build/report/stability

.PHONY: lessons
lessons: deps-demo  ## a booklet on shading, into build/lessons/index.html
	@$(SUBMAKE) $(CLI)
	@$(CLI) lesson all -o build/lessons

CHECKS := check-selftest check-layers check-equations check-format check-headers
HEADERS := $(shell find include -name '*.hpp' 2>/dev/null | sort)
FORMATTED = $(shell find include src tests -name '*.hpp' -o -name '*.cpp' | sort)

.PHONY: check $(CHECKS)
check: deps-test  ## layers, equations, formatting, each header alone; under a minute
	@$(SUBMAKE) -k --output-sync $(CHECKS) && echo "all checks passed"
check-selftest:
	@python3 tests/support/checks_test.py --quiet
check-layers:
	@python3 tests/support/check_layers.py
check-equations:
	@python3 tests/support/check_equations.py
check-format:
	@odd=$$(clang-format --dry-run $(FORMATTED) 2>&1 | sed -n 's/:[0-9].*warning:.*//p' | sort -u); \
	if [ -n "$$odd" ]; then echo "$$odd"; echo "format: run 'make format' for these files"; exit 1; \
	else echo "format: as clang-format wants it"; fi
check-headers:
	@CXX='$(CXX)' python3 tests/support/check_headers.py $(HEADERS) -- \
	    $(filter-out -M%,$(CXXFLAGS_COMMON)) -Werror

# Those of the ten cases in docs/numerics.md.
STABILITY_PICTURES := $(addsuffix .svg,$(addprefix equation-,A3-1 B11-2 B12-1 B17d-1 B20-2 C5-1 D3-2)) \
    $(addsuffix .png,$(addprefix case-,exponent-1e6 offset-1e7-file w-ratio-1e6 near-coplanar-1e-7))

.PHONY: docs
docs: deps-report  ## write docs/equations.md and all pictures of README.md and docs/ again
	@python3 tests/support/check_equations.py --write
	@$(SUBMAKE) $(CLI)
	@mkdir -p docs/images
	$(CLI) render $(DEMO_SCENE) --resolution 960,540 --samples 16 -o docs/images/teapot.png
	$(CLI) sheet $(DEMO_SCENE) --resolution 240,180 --samples 16 -o docs/images/sheet.png
	$(CLI) report stability -o build/report/stability
	@mkdir -p docs/images/stability
	cp $(STABILITY_PICTURES:%=build/report/stability/%) docs/images/stability/
	$(CLI) report error $(DEMO_SCENE) --resolution 480,360 --threads 1 --runs 21 -o build/report/error-docs
	cp build/report/error-docs/interpolation-1.svg docs/images/error.svg

.PHONY: golden golden-accept
golden: deps-test  ## compare pictures with golden/; drawn ones and differences go to build/golden/
	@$(SUBMAKE) $(TESTS)
	@$(TESTS) '[golden]' || { echo "look at build/golden/NAME.png and NAME.diff.png;" \
	    "'make golden-accept NAME=...' takes one picture over"; exit 1; }
golden-accept:  ## take one picture over: build/golden/NAME.png becomes golden/NAME.png
	@case '$(NAME)' in \
	    '' | *[!A-Za-z0-9_-]*) echo "give one name: make golden-accept NAME=teapot"; exit 2;; esac
	@test -f 'build/golden/$(NAME).png' || \
	    { echo "build/golden/$(NAME).png is not there; run 'make golden' first"; exit 2; }
	@$(SUBMAKE) $(CLI)
	@if [ -f 'golden/$(NAME).png' ]; then \
	    $(CLI) compare 'golden/$(NAME).png' 'build/golden/$(NAME).png' || [ $$? -eq 1 ]; \
	else echo "golden/$(NAME).png is new"; fi
	cp 'build/golden/$(NAME).png' 'golden/$(NAME).png'

# Each file by itself: warnings of both compilers, clang-tidy, cppcheck. Clean ones are looked at again
# where they or what they include changed.
LINT   := build/lint
LINTED := $(wildcard src/*/*.cpp src/*/*/*.cpp tests/*/*.cpp)
LINT_FLAGS = $(filter-out -M% -Wno-psabi,$(CXXFLAGS_COMMON)) $(SDL_CFLAGS) -DSCANSHADE_BINARY='""'
# Not asked of cppcheck: numbers and scratch arrays are not filled twice (compilers and valgrind see
# what is read too early); rows of batches hold floats or integers of 32 bits; and what it does not
# understand: a result that outlives its temporary, the macros of Highway.
CPPCHECK := cppcheck --quiet --std=c++20 --language=c++ --enable=warning,performance,portability \
            --inline-suppr --error-exitcode=1 -Iinclude -Isrc -Itests $(addprefix --suppress=, \
            uninitMemberVar invalidPointerCast returnDanglingLifetime preprocessorErrorDirective \
            toomanyconfigs syntaxError:tests/eq/number_types_test.cpp)
.PHONY: lint
lint: deps-lint  ## GCC's and clang's warnings, clang-tidy, cppcheck; minutes, then only what changed
	@$(SUBMAKE) --output-sync -k $(LINTED:%.cpp=$(LINT)/%.ok) && echo "lint: all $(words $(LINTED)) files are clean" || \
	    { echo "lint: some files are not clean; see above"; exit 1; }
$(LINT)/%.ok: %.cpp .clang-tidy tests/.clang-tidy | $(BUILD)/gen/brdf_models.inc $(FACTS)
	@mkdir -p $(@D)
	@echo "  LINT $<"
	@g++ $(LINT_FLAGS) -Wno-psabi -Werror -fsyntax-only $<
	@clang++ $(LINT_FLAGS) -Werror -fsyntax-only -MD -MP -MF $(@:.ok=.d) -MT $@ $<
	@clang-tidy --quiet $< -- $(LINT_FLAGS) 2>/dev/null
	@$(CPPCHECK) $<
	@touch $@
-include $(LINTED:%.cpp=$(LINT)/%.d)

.PHONY: format
format:  ## clang-format on all sources
	@clang-format -i $(FORMATTED)

.PHONY: clean
clean:  ## remove everything that was built
	rm -rf build

.PHONY: help
help:  ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "  make %-14s %s\n", $$1, $$2}' $(firstword $(MAKEFILE_LIST))
	@echo
	@echo "  config=release|debug|asan|tsan|coverage|fuzz  which build (default release), in build/CONFIG/"
	@echo "  JOBS=N                      how many compilers run at once (default: one a core)"
