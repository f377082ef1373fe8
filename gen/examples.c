#include "examples.h"

#include "die.h"
#include "nearest.h"

#include <stdio.h>
#include <string.h>

/* One a file of gen/examples; the first line of each, a comment, is what it shows. */
#define EXAMPLES(DO) DO(plate) DO(harmonic) DO(random) DO(fracture) DO(crack) DO(study) DO(compare)

/* The assembler puts the file in, from the folder that the tree is built in; a NUL ends it. */
#define TAKE(name)                                                                                 \
    __asm__(".pushsection .rodata\n"                                                               \
            "example_" #name ": .incbin \"gen/examples/" #name ".yaml\"\n"                         \
            ".byte 0\n"                                                                            \
            ".popsection\n");                                                                      \
    extern const char text_##name[] __asm__("example_" #name);
EXAMPLES(TAKE)

#define NAME(name) #name,
#define TEXT(name) text_##name,
static const char *const names[] = {EXAMPLES(NAME)};
static const char *const texts[] = {EXAMPLES(TEXT)};
enum { COUNT = sizeof names / sizeof *names };

#define BEHIND(name) "|" #name
static const char behind[] = EXAMPLES(BEHIND);
const char *const examples_names = behind + 1;

void examples_list(void)
{
    for (int i = 0; i < COUNT; i++)
        printf("%-10s %.*s\n", names[i], (int)strcspn(texts[i], "\n") - 2, texts[i] + 2);
    printf("\n'hsgen --example NAME > study.yaml' writes one\n");
}

void example_print(const char *name)
{
    for (int i = 0; i < COUNT; i++)
        if (strcmp(names[i], name) == 0) {
            fputs(texts[i], stdout);
            return;
        }
    const char *nearest = nearest_name(name, names, COUNT);
    die_user("--example %.60s: there is none (%s%s%sknown: %s)", name,
             nearest ? "did you mean " : "", nearest ? nearest : "", nearest ? "? " : "",
             nearest_list(names, COUNT));
}
