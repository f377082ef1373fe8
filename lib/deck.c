#include "deck.h"

#include "die.h"
#include "memory.h"
#include "nearest.h"
#include "spool.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

enum { LARGEST = 1000000, DEEPEST = 32, MOST_KEYS = 1000 };

struct deck {
    char *name, *text;
    yaml_document_t document;
};

const char *deck_library(void)
{
    static char text[32];
    snprintf(text, sizeof text, "libyaml %s", yaml_get_version_string());
    return text;
}

/* --- positions -------------------------------------------------------------------------------- */

static _Noreturn void die_at(const char *name, yaml_mark_t mark, const char *message)
{
    die_user("%s:%zu:%zu: %s", name, mark.line + 1, mark.column + 1, message);
}

static yaml_node_t *yaml_node(struct deck_node node)
{
    if (node.index == 0) return NULL;
    /* libyaml takes the document without const, and does not change it here. */
    return yaml_document_get_node((yaml_document_t *)&node.deck->document, node.index);
}

int deck_line(struct deck_node node)
{
    const yaml_node_t *at = yaml_node(node);
    return at ? (int)at->start_mark.line + 1 : 0;
}

void deck_error(struct deck_node where, const char *format, ...)
{
    char message[4096];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    const yaml_node_t *node = yaml_node(where);
    if (node == NULL) die_user("%s: %s", where.deck->name, message);
    die_at(where.deck->name, node->start_mark, message);
}

/* --- reading ---------------------------------------------------------------------------------- */

/* Editors of Windows put it before the text; libyaml, told the encoding, takes it for a part of
 * that. */
static const char byte_order_mark[] = "\xef\xbb\xbf";

static void start_parser(yaml_parser_t *parser, const char *text, size_t length)
{
    const size_t mark = sizeof byte_order_mark - 1;
    if (length >= mark && memcmp(text, byte_order_mark, mark) == 0) {
        text += mark;
        length -= mark;
    }
    if (!yaml_parser_initialize(parser)) die_run("out of memory for the deck");
    yaml_parser_set_encoding(parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(parser, (const unsigned char *)text, length);
}

static _Noreturn void die_of_parser(const yaml_parser_t *parser, const char *name)
{
    char message[512];
    if (parser->error == YAML_MEMORY_ERROR) die_run("out of memory for the deck");
    if (parser->error == YAML_READER_ERROR)
        die_user("%s: byte %zu: %s", name, parser->problem_offset + 1, parser->problem);
    snprintf(message, sizeof message, "%s%s%s", parser->context ? parser->context : "",
             parser->context ? ": " : "", parser->problem ? parser->problem : "not YAML");
    die_at(name, parser->problem_mark, message);
}

/* Goes through the events before the tree is built: libyaml's time grows with the square of the
 * depth.  Returns the number of documents. */
static int check_events(const char *text, size_t length, const char *name)
{
    yaml_parser_t parser;
    yaml_event_t event = {0};
    int depth = 0, documents = 0;
    start_parser(&parser, text, length);
    do {
        yaml_event_delete(&event);
        if (!yaml_parser_parse(&parser, &event)) die_of_parser(&parser, name);
        if (event.type == YAML_DOCUMENT_START_EVENT && ++documents > 1)
            die_at(name, event.start_mark, "a second document begins; expected one");
        if (event.type == YAML_SEQUENCE_START_EVENT || event.type == YAML_MAPPING_START_EVENT)
            depth++;
        if (event.type == YAML_SEQUENCE_END_EVENT || event.type == YAML_MAPPING_END_EVENT) depth--;
        if (depth > DEEPEST) die_at(name, event.start_mark, "nested too deep; expected at most 32");
    } while (event.type != YAML_STREAM_END_EVENT);
    yaml_event_delete(&event);
    yaml_parser_delete(&parser);
    return documents;
}

static int compare_keys(const void *a, const void *b)
{
    const yaml_node_t *const *first = a, *const *second = b;
    int order = strcmp((const char *)(*first)->data.scalar.value,
                       (const char *)(*second)->data.scalar.value);
    return order != 0 ? order : (*first > *second) - (*first < *second);
}

static void check_scalar(struct deck_node node)
{
    const yaml_node_t *scalar = yaml_node(node);
    if (strlen((const char *)scalar->data.scalar.value) != scalar->data.scalar.length)
        deck_error(node, "a text with a NUL character");
}

static void check_keys(struct deck_node map)
{
    yaml_node_t *keys[MOST_KEYS];
    int count = deck_count(map);
    if (count > MOST_KEYS) deck_error(map, "%d keys, expected at most %d", count, MOST_KEYS);
    for (int i = 0; i < count; i++) {
        struct deck_node key = {map.deck, yaml_node(map)->data.mapping.pairs.start[i].key};
        if (!deck_is_scalar(key)) deck_error(key, "a key that is a list or a mapping");
        check_scalar(key);
        keys[i] = yaml_node(key);
    }
    qsort(keys, (size_t)count, sizeof *keys, compare_keys);
    for (int i = 1; i < count; i++) {
        const char *key = (const char *)keys[i]->data.scalar.value;
        char message[128];
        if (strcmp((const char *)keys[i - 1]->data.scalar.value, key) != 0) continue;
        snprintf(message, sizeof message, "key '%.60s' stands here for the second time", key);
        die_at(map.deck->name, keys[i]->start_mark, message);
    }
}

enum visit { NEW, OPEN, DONE };

/* Depth first; an alias that leads back to an open node is a cycle.  A node that several aliases
 * name is entered once, so that their number cannot multiply; aliases name earlier nodes, so they
 * do not add to the depth. */
static void check_tree(struct deck_node node, unsigned char visits[])
{
    if (visits[node.index] == DONE) return;
    if (visits[node.index] == OPEN) deck_error(node, "contains itself through an alias");
    visits[node.index] = OPEN;
    if (deck_is_scalar(node)) check_scalar(node);
    if (deck_is_map(node)) check_keys(node);
    for (int i = 0; deck_is_map(node) && i < deck_count(node); i++)
        check_tree(deck_value(node, i), visits);
    for (int i = 0; deck_is_list(node) && i < deck_count(node); i++)
        check_tree(deck_item(node, i), visits);
    visits[node.index] = DONE;
}

struct deck *deck_parse(const char *text, size_t length, const char *name)
{
    if (length > LARGEST) die_user("%s: larger than 1 MB, expected a deck", name);
    struct deck *deck = memory_new(1, sizeof *deck);
    deck->name = memory_text(name);
    deck->text = memory_new(length + 1, 1);
    memcpy(deck->text, text, length);
    if (check_events(deck->text, length, name) == 0)
        die_user("%s: empty, expected a deck in YAML", name);
    yaml_parser_t parser;
    start_parser(&parser, deck->text, length);
    if (!yaml_parser_load(&parser, &deck->document)) die_of_parser(&parser, name);
    yaml_parser_delete(&parser);
    struct deck_node root = deck_root(deck);
    if (!deck_is_map(root)) deck_error(root, "expected a mapping (key: value) at the top");
    size_t nodes = (size_t)(deck->document.nodes.top - deck->document.nodes.start);
    unsigned char *visits = memory_new(nodes + 1, 1);
    check_tree(root, visits);
    free(visits);
    return deck;
}

struct deck *deck_read(const char *path)
{
    long length;
    char *text = spool_text(path, LARGEST, &length);
    bool piped = path == NULL || strcmp(path, "-") == 0;
    struct deck *deck = deck_parse(text, (size_t)length, piped ? "standard input" : path);
    free(text);
    return deck;
}

void deck_free(struct deck *deck)
{
    if (deck == NULL) return;
    yaml_document_delete(&deck->document);
    free(deck->name);
    free(deck->text);
    free(deck);
}

const char *deck_text(const struct deck *deck)
{
    return deck->text;
}

const char *deck_name(const struct deck *deck)
{
    return deck->name;
}

/* --- the tree --------------------------------------------------------------------------------- */

struct deck_node deck_root(const struct deck *deck)
{
    return (struct deck_node){deck, 1};
}

static bool is(struct deck_node node, yaml_node_type_t type)
{
    const yaml_node_t *found = yaml_node(node);
    return found != NULL && found->type == type;
}

bool deck_is_map(struct deck_node node)
{
    return is(node, YAML_MAPPING_NODE);
}

bool deck_is_list(struct deck_node node)
{
    return is(node, YAML_SEQUENCE_NODE);
}

bool deck_is_scalar(struct deck_node node)
{
    return is(node, YAML_SCALAR_NODE);
}

static void expect(struct deck_node node, yaml_node_type_t type)
{
    if (is(node, type)) return;
    deck_error(node, "expected %s",
               type == YAML_MAPPING_NODE    ? "a mapping (key: value)"
               : type == YAML_SEQUENCE_NODE ? "a list"
                                            : "a single value");
}

int deck_count(struct deck_node node)
{
    const yaml_node_t *found = yaml_node(node);
    if (deck_is_map(node))
        return (int)(found->data.mapping.pairs.top - found->data.mapping.pairs.start);
    expect(node, YAML_SEQUENCE_NODE);
    return (int)(found->data.sequence.items.top - found->data.sequence.items.start);
}

struct deck_node deck_item(struct deck_node list, int i)
{
    expect(list, YAML_SEQUENCE_NODE);
    if (i < 0 || i >= deck_count(list))
        deck_error(list, "a list of %d, expected at least %d items", deck_count(list), i + 1);
    return (struct deck_node){list.deck, yaml_node(list)->data.sequence.items.start[i]};
}

static yaml_node_pair_t pair(struct deck_node map, int i)
{
    expect(map, YAML_MAPPING_NODE);
    if (i < 0 || i >= deck_count(map)) deck_error(map, "expected at least %d keys", i + 1);
    return yaml_node(map)->data.mapping.pairs.start[i];
}

struct deck_node deck_key_node(struct deck_node map, int i)
{
    return (struct deck_node){map.deck, pair(map, i).key};
}

const char *deck_key(struct deck_node map, int i)
{
    return deck_string(deck_key_node(map, i));
}

struct deck_node deck_value(struct deck_node map, int i)
{
    return (struct deck_node){map.deck, pair(map, i).value};
}

struct deck_node deck_find(struct deck_node map, const char *key)
{
    expect(map, YAML_MAPPING_NODE);
    for (int i = 0; i < deck_count(map); i++)
        if (strcmp(deck_key(map, i), key) == 0) return deck_value(map, i);
    return (struct deck_node){map.deck, 0};
}

bool deck_has(struct deck_node map, const char *key)
{
    return deck_find(map, key).index != 0;
}

struct deck_node deck_get(struct deck_node map, const char *key)
{
    struct deck_node found = deck_find(map, key);
    if (found.index == 0) deck_error(map, "key '%s' is missing here", key);
    return found;
}

void deck_keys(struct deck_node map, const char *const known[])
{
    int count = 0;
    while (known[count] != NULL) count++;
    expect(map, YAML_MAPPING_NODE);
    for (int i = 0; i < deck_count(map); i++) {
        const char *key = deck_key(map, i);
        bool found = false;
        for (int k = 0; k < count; k++) found = found || strcmp(key, known[k]) == 0;
        if (found) continue;
        const char *nearest = nearest_name(key, known, count);
        deck_error((struct deck_node){map.deck, pair(map, i).key},
                   "unknown key '%.60s' (%s%s%sknown: %s)", key, nearest ? "did you mean " : "",
                   nearest ? nearest : "", nearest ? "? " : "", nearest_list(known, count));
    }
}

const char *deck_string(struct deck_node node)
{
    expect(node, YAML_SCALAR_NODE);
    const yaml_node_t *scalar = yaml_node(node);
    if (scalar->data.scalar.length == 0) deck_error(node, "a value is missing here");
    return (const char *)scalar->data.scalar.value;
}

/* --- where it is written ---------------------------------------------------------------------- */

bool deck_is_block(struct deck_node node)
{
    const yaml_node_t *found = yaml_node(node);
    if (deck_is_map(node)) return found->data.mapping.style != YAML_FLOW_MAPPING_STYLE;
    if (deck_is_list(node)) return found->data.sequence.style != YAML_FLOW_SEQUENCE_STYLE;
    return found->data.scalar.style == YAML_LITERAL_SCALAR_STYLE ||
           found->data.scalar.style == YAML_FOLDED_SCALAR_STYLE;
}

/* libyaml counts characters. */
static size_t byte_of(const struct deck *deck, size_t characters)
{
    const size_t mark = sizeof byte_order_mark - 1;
    const char *at = deck->text + (strncmp(deck->text, byte_order_mark, mark) == 0 ? mark : 0);
    for (; characters > 0 && *at; characters--)
        for (at++; (*at & 0xc0) == 0x80;) at++;
    return (size_t)(at - deck->text);
}

/* An anchor or a tag belongs to the place, not to the value, which may be nothing. */
static size_t skip_properties(const struct deck *deck, struct deck_span span)
{
    size_t at = span.begin;
    while (at < span.end && (deck->text[at] == '&' || deck->text[at] == '!')) {
        at += strcspn(deck->text + at, " \t\r\n");
        at += strspn(deck->text + at, " \t\r\n");
    }
    return at < span.end ? at : span.end;
}

/* A block goes on, for libyaml, to what follows it; here it ends with the last of what it holds.
 * What an alias names stands elsewhere, before its key: such a line ends the block whole. */
static size_t end_of_block(struct deck_node node, size_t begin)
{
    size_t end = begin;
    for (int i = 0; i < deck_count(node); i++) {
        const struct deck_node child = deck_is_map(node) ? deck_value(node, i) : deck_item(node, i);
        const size_t from = deck_is_map(node) ? deck_span(deck_key_node(node, i)).end : end;
        const struct deck_span span = deck_span(child);
        end = span.begin >= from ? span.end : from + strcspn(node.deck->text + from, "#\r\n");
    }
    return end;
}

struct deck_span deck_span(struct deck_node node)
{
    const yaml_node_t *found = yaml_node(node);
    struct deck_span span = {byte_of(node.deck, found->start_mark.index),
                             byte_of(node.deck, found->end_mark.index)};
    span.begin = skip_properties(node.deck, span);
    if (!deck_is_scalar(node) && deck_is_block(node)) span.end = end_of_block(node, span.begin);
    return span;
}
