# Triangulations in R2: everything is built in build/; `make help` lists the targets.

.SUFFIXES:
.DELETE_ON_ERROR:
.SECONDARY:
.DEFAULT_GOAL := all
.PHONY: all help demo test test-long check weave figures book bench compare mutants \
        verify-grading verify-handouts verify-weeks verify-variants asan \
        install uninstall clean

# Two commands at a time (JOBS=4: four), each said in a word (V=1: shown in full).
JOBS ?= 2
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(JOBS)
endif
$(V).SILENT:
SAY = $(if $(V)$(findstring s,$(firstword -$(MAKEFLAGS))),:,echo)

CFLAGS   ?= -O3 -g
WARNINGS := -Wall -Wextra -Wshadow -Wconversion -Wpedantic
BUILD    ?= build
# Programs and tests are POSIX; the library is plain C11 and does not need the macro.
COMPILE = $(CC) -std=c11 $(WARNINGS) -ffp-contract=off -I. -MMD -MP $(CFLAGS)

# The fast algorithm of 3.7 can use threads; some C libraries keep them apart.
LIBS    = -lm -pthread

LIBRARY  := $(wildcard lib/*.c) $(filter-out %/figures.c,$(wildcard chapters/*.c chapters/*/*.c))
FIGURES  := $(patsubst chapters/%/figures.c,%,$(wildcard chapters/*/figures.c))
SECTIONS := $(sort $(foreach d,$(wildcard chapters/[0-9]*),$(firstword $(subst _, ,$(notdir $d)))))
HARNESS  := $(wildcard tests/harness/*.c tests/oracle/*.c)
TESTS    := $(patsubst tests/%.c,%,$(wildcard tests/[0-9]*.c tests/lib_*.c tests/tools_*.c))
TRI      := $(wildcard tools/tri/*.c)
WEAVE    := $(wildcard tools/weave/*.c)
BENCH    := $(filter-out %/tiers.c,$(wildcard tools/bench/*.c)) tools/tri/distributions.c
JAIL     := $(addprefix tools/grade/,jail.c inside.c outside.c confine.c filter.c)
GRADE    := $(filter-out $(JAIL),$(wildcard tools/grade/*.c)) \
            $(addprefix tools/handout/,basics.c exercises.c scan.c)
COMPARE  := tools/compare/contestants.c tools/tri/distributions.c
HANDOUT  := $(filter-out %/splice.c %/traces.c %/questions.c,$(wildcard tools/handout/*.c))
SPLICE   := $(addprefix tools/handout/,basics.c exercises.c rewrite.c scan.c splice.c)
TOOLS    := $(patsubst tools/%.c,%,$(wildcard tools/*.c))
CHECKS   := $(patsubst tools/checks/%.c,%,$(wildcard tools/checks/[0-9]*.c))
CHECKING := $(filter-out $(CHECKS:%=tools/checks/%.c) tools/checks/signs.c,$(wildcard tools/checks/*.c))

PLAIN   = $(LIBRARY:%.c=$(BUILD)/plain/%.o)
COUNTED = $(LIBRARY:%.c=$(BUILD)/counted/%.o)

all: $(BUILD)/libtri.a $(BUILD)/tri $(BUILD)/counted/tri $(BUILD)/weave $(BUILD)/jail \
     $(BUILD)/handout $(BUILD)/splice $(BUILD)/signs \
     $(BUILD)/bench/bench $(BUILD)/bench/tiers \
     $(BUILD)/compare/counts $(BUILD)/compare/times \
     $(TOOLS:%=$(BUILD)/%) $(CHECKS:%=$(BUILD)/checker_%) \
     $(TESTS:%=$(BUILD)/test/%) $(FIGURES:%=$(BUILD)/figures/%)

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## /  make \1|/p' Makefile | \
	  awk -F'|' '{ printf "%-18s %s\n", $$1, $$2 }'
	@echo "  make SECTION     build, test and draw one section: $(SECTIONS)"

# ---- The library: plain, and once more with every question counted. ----

$(BUILD)/plain/%.o: %.c
	@mkdir -p $(@D)
	@$(SAY) "  cc    $<"
	$(COMPILE) -c $< -o $@

$(BUILD)/counted/%.o: %.c
	@mkdir -p $(@D)
	@$(SAY) "  cc    $<"
	$(COMPILE) -DTRI_COUNTED -c $< -o $@

$(BUILD)/libtri.a: $(PLAIN)
	@rm -f $@
	@$(SAY) "  ar    $@"
	ar rcs $@ $^

$(BUILD)/counted/libtri.a: $(COUNTED)
	@rm -f $@
	@$(SAY) "  ar    $@"
	ar rcs $@ $^

# ---- Programs, tests, figures: POSIX, on top of the library. ----

POSIX = -D_POSIX_C_SOURCE=200809L

$(BUILD)/posix/%.o: %.c
	@mkdir -p $(@D)
	@$(SAY) "  cc    $<"
	$(COMPILE) $(POSIX) -c $< -o $@

$(BUILD)/posix-counted/%.o: %.c
	@mkdir -p $(@D)
	@$(SAY) "  cc    $<"
	$(COMPILE) $(POSIX) -DTRI_COUNTED -c $< -o $@

$(BUILD)/tri: $(TRI:%.c=$(BUILD)/posix/%.o) $(BUILD)/libtri.a
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

$(BUILD)/counted/tri: $(TRI:%.c=$(BUILD)/posix-counted/%.o) $(BUILD)/counted/libtri.a
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

$(BUILD)/weave: $(WEAVE:%.c=$(BUILD)/posix/%.o)
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@

$(BUILD)/grade: $(GRADE:%.c=$(BUILD)/posix/%.o) $(BUILD)/libtri.a | \
    $(BUILD)/jail $(BUILD)/handout $(BUILD)/splice
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

$(BUILD)/jail: $(JAIL:%.c=$(BUILD)/posix/%.o)
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@

$(BUILD)/handout: $(HANDOUT:%.c=$(BUILD)/posix/%.o) | $(BUILD)/weave $(BUILD)/signs $(BUILD)/traces
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@

$(BUILD)/traces: $(addprefix $(BUILD)/posix/tools/handout/,traces.o questions.o) $(BUILD)/libtri.a
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

$(BUILD)/splice: $(SPLICE:%.c=$(BUILD)/posix/%.o)
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@

$(BUILD)/bench/bench: $(BENCH:%.c=$(BUILD)/posix/%.o) $(BUILD)/libtri.a
	@mkdir -p $(@D)
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

$(BUILD)/compare/counts: $(patsubst %.c,$(BUILD)/posix-counted/%.o,tools/compare/counts.c $(COMPARE)) \
                         $(BUILD)/counted/libtri.a
	@mkdir -p $(@D)
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

$(BUILD)/compare/times: $(patsubst %.c,$(BUILD)/posix/%.o,tools/compare/times.c $(COMPARE) \
                          $(addprefix tools/bench/,measure.c certify.c stopwatch.c yardstick.c)) \
                        $(BUILD)/libtri.a
	@mkdir -p $(@D)
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

$(BUILD)/bench/tiers: $(BUILD)/posix-counted/tools/bench/tiers.o $(BUILD)/counted/libtri.a
	@mkdir -p $(@D)
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

$(TOOLS:%=$(BUILD)/%): $(BUILD)/%: $(BUILD)/posix/tools/%.o $(BUILD)/libtri.a
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

# One checker for each section: it certifies what a student's program answers.
$(BUILD)/checker_%: $(CHECKING:%.c=$(BUILD)/posix/%.o) $(BUILD)/posix/tools/checks/%.o \
                    $(BUILD)/libtri.a
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

# The instances of 3.4 have their signs from big integers.
$(BUILD)/signs: $(BUILD)/posix/tools/checks/signs.o $(BUILD)/posix/tests/oracle/oracle.o \
                $(BUILD)/posix/tests/oracle/big.o $(BUILD)/libtri.a
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

$(BUILD)/figures/%: $(BUILD)/posix/chapters/%/figures.o $(BUILD)/libtri.a
	@mkdir -p $(@D)
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

# Tests ask the counted library, so that they can say what they have reached.
$(BUILD)/test/%: $(BUILD)/posix-counted/tests/%.o \
                 $(HARNESS:%.c=$(BUILD)/posix-counted/%.o) $(BUILD)/counted/libtri.a
	@mkdir -p $(@D)
	@$(SAY) "  link  $@"
	$(CC) $(CFLAGS) $^ -o $@ $(LIBS)

# These ask the grader's certifiers.
$(filter $(BUILD)/test/tools_certify%,$(TESTS:%=$(BUILD)/test/%)): \
  $(patsubst %,$(BUILD)/posix-counted/tools/checks/%.o,cases certify complexes diagrams \
  lifted meshes plane replay sphere trees turns)

# And this one those of the benchmark.
$(BUILD)/test/tools_bench: $(BUILD)/posix-counted/tools/bench/certify.o | $(BUILD)/bench/bench

# Some tests drive programs: these must be there, and may be younger.
$(filter $(BUILD)/test/tools_% $(BUILD)/test/3.1_tri_%,$(TESTS:%=$(BUILD)/test/%)): | \
    $(BUILD)/tri $(BUILD)/counted/tri $(BUILD)/weave $(BUILD)/jail $(BUILD)/grade \
    $(BUILD)/handout $(BUILD)/splice $(TOOLS:%=$(BUILD)/%)

$(BUILD)/test/3.7_comparison: | $(BUILD)/compare/counts

# ---- What people run. ----

demo: $(BUILD)/tri $(BUILD)/counted/tri ## triangulate, certify and draw the shipped real points
	tools/demo.sh $(BUILD)

test: all ## every test, in under two minutes on two cores
	tests/run.sh $(BUILD) $(TESTS)

test-long: all ## the same with more trials, compilers and flags; then fuzzing
	tests/run_long.sh $(BUILD) $(TESTS)

check: $(BUILD)/libtri.a $(BUILD)/weave $(BUILD)/deps $(BUILD)/tri ## all that can be checked without geometry
	+tools/check.sh $(BUILD)

weave: $(BUILD)/weave $(BUILD)/tri ## refresh the code and the steps quoted in the pages
	$(BUILD)/weave
	tools/book/say.sh $(BUILD)

figures: $(FIGURES:%=$(BUILD)/figures/%) ## draw every figure of the pages again
	@for f in $(FIGURES); do mkdir -p "chapters/$$f/figures" && \
	  $(BUILD)/figures/$$f "chapters/$$f/figures" || exit 1; done

book: $(BUILD)/weave $(BUILD)/tri ## the pages as a static HTML book in build/book/ (needs pandoc)
	tools/book.sh $(BUILD)

PEERS = $(patsubst %,$(BUILD)/posix/tools/bench/%.o,peers/main stopwatch certify)

bench: $(BUILD)/bench/bench $(BUILD)/bench/tiers $(BUILD)/tri $(PEERS) ## times, and aims, beside sorting and other libraries (11 minutes)
	CC="$(CC)" CFLAGS="$(CFLAGS)" tools/bench/peers.sh $(BUILD)
	$(BUILD)/bench/bench -o $(BUILD)/bench

compare: $(BUILD)/compare/counts $(BUILD)/compare/times ## section 3.7's comparison, again: counts, then times
	tools/compare/compare.sh $(BUILD)

mutants: ## plant bugs one by one; each must be caught by a named statement
	tests/mutants/run.sh

verify-grading: $(BUILD)/grade ## wrong, right and hostile submissions: the grader says so (3 minutes)
	tests/grading/run.sh $(BUILD)

verify-handouts: verify-weeks verify-variants ## the promises of every week's handout, and of each variant

verify-weeks: $(BUILD)/handout
	tests/grading/handouts.sh $(BUILD)

verify-variants: $(BUILD)/handout
	tests/grading/variants.sh $(BUILD)

asan: ## all tests with the address and undefined-behaviour sanitizers
	$(MAKE) BUILD=$(BUILD)/asan \
	  CFLAGS="-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all" test

# One section: its tests and its pictures, and what they stand on.
$(foreach s,$(SECTIONS),$(eval $(s): \
  $(addprefix $(BUILD)/test/,$(filter $(s)_%,$(TESTS))) \
  $(addprefix $(BUILD)/figures/,$(filter $(s)_%,$(FIGURES)))))
$(SECTIONS): %: $(BUILD)/tri $(BUILD)/counted/tri
	tests/run.sh $(BUILD) $(filter $*_%,$(TESTS))
	@for f in $(filter $*_%,$(FIGURES)); do mkdir -p "chapters/$$f/figures" && \
	  $(BUILD)/figures/$$f "chapters/$$f/figures" && \
	  echo "pictures: chapters/$$f/figures/" || exit 1; done
.PHONY: $(SECTIONS)

# The folders of the headers stay as they are: a program includes
# "chapters/triangulations.h", as in this tree.
PREFIX  ?= /usr/local
HEADERS := $(filter-out chapters/figures.h,$(wildcard lib/*.h chapters/*.h chapters/*/*.h))
TO      = $(DESTDIR)$(PREFIX)

install: $(BUILD)/tri $(BUILD)/libtri.a ## tri, the library and its headers to PREFIX=/usr/local
	@$(SAY) "  install in $(TO)"
	mkdir -p "$(TO)/bin" "$(TO)/lib/pkgconfig"
	cp -f $(BUILD)/tri "$(TO)/bin/tri"
	cp -f $(BUILD)/libtri.a "$(TO)/lib/libtri.a"
	sed 's|@PREFIX@|$(PREFIX)|' tools/triangulations.pc.in \
	  >"$(TO)/lib/pkgconfig/triangulations.pc"
	@for h in $(HEADERS); do mkdir -p "$(TO)/include/triangulations/$${h%/*}" && \
	  cp -f "$$h" "$(TO)/include/triangulations/$$h" || exit 1; done

uninstall: ## what install has put there is removed
	rm -rf "$(TO)/include/triangulations"
	rm -f "$(TO)/bin/tri" "$(TO)/lib/libtri.a" "$(TO)/lib/pkgconfig/triangulations.pc"

clean: ## remove build/
	rm -rf $(BUILD)

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
