// SPDX-License-Identifier: Apache-2.0
/// vesica_join(a, b): the library's own join over the shapes of two tables.
#include "vshape.h"

#include "access/relation.h"
#include "catalog/pg_class.h"
#include "catalog/pg_type.h"
#include "executor/spi.h"
#include "funcapi.h"
#include "miscadmin.h"
#include "parser/parse_type.h"
#include "storage/itemptr.h"
#include "utils/builtins.h"
#include "utils/lsyscache.h"
#include "utils/memutils.h"
#include "utils/rel.h"
#include "utils/syscache.h"
#include "utils/tuplestore.h"

enum { kind_count = 10, rows_a_fetch = 10000, pairs_a_call = 4096 };

/// The shapes of a table, kind by kind as the library takes them, and the row of each.
struct side {
  Oid table;
  int64 used[kind_count], room[kind_count];
  char* records[kind_count];  // numbers, or structs of polygons and polylines
  ItemPointerData* rows[kind_count];
  vesica_shapes_f64 sets[kind_count];
  void* index;
};

static void* aligned_memory(MemoryContext context, int64_t bytes) {
  if (bytes < 0)
    ereport(ERROR, (errcode(ERRCODE_PROGRAM_LIMIT_EXCEEDED), errmsg("a join takes at most 2147483647 shapes a table")));
  return (void*)TYPEALIGN(64, MemoryContextAllocHuge(context, (Size)bytes + 64));
}

// ---- Reading a table ----

// The one column of the type, quoted.
static const char* shape_column(Relation table, Oid type) {
  const TupleDesc columns = RelationGetDescr(table);
  const char* name = NULL;
  for (int i = 0; i < columns->natts; i++) {
    const FormData_pg_attribute* column = TupleDescAttr(columns, i);
    if (column->attisdropped || column->atttypid != type) continue;
    if (name)
      ereport(ERROR, (errcode(ERRCODE_AMBIGUOUS_COLUMN),
                      errmsg("\"%s\" has several columns of type vshape", RelationGetRelationName(table))));
    name = quote_identifier(NameStr(column->attname));
  }
  if (!name)
    ereport(ERROR, (errcode(ERRCODE_UNDEFINED_COLUMN),
                    errmsg("\"%s\" has no column of type vshape", RelationGetRelationName(table))));
  return name;
}

// A row's ctid identifies it in one table only. Partitioned tables and views have none.
static char* selection(Oid oid, Oid type) {
  Relation table = relation_open(oid, AccessShareLock);
  char* query;
  if (table->rd_rel->relkind != RELKIND_RELATION && table->rd_rel->relkind != RELKIND_MATVIEW)
    ereport(ERROR, (errcode(ERRCODE_WRONG_OBJECT_TYPE),
                    errmsg("\"%s\" is neither a table nor a materialized view", RelationGetRelationName(table))));
  query = psprintf(
      "SELECT ctid, %s FROM ONLY %s", shape_column(table, type),
      quote_qualified_identifier(get_namespace_name(RelationGetNamespace(table)), RelationGetRelationName(table)));
  relation_close(table, NoLock);
  return query;
}

static Size record_size(int32_t kind) {
  return shape_has_path(kind) ? sizeof(vesica_polygon_f64) : (Size)vesica_field_count(kind) * sizeof(double);
}

static void make_room(struct side* side, MemoryContext context, int32_t kind) {
  const int64 room = side->room[kind] ? 2 * side->room[kind] : 1024;
  const Size records = (Size)room * record_size(kind);
  const Size rows = (Size)room * sizeof(ItemPointerData);
  side->records[kind] =
      side->room[kind] ? repalloc_huge(side->records[kind], records) : MemoryContextAllocHuge(context, records);
  side->rows[kind] = side->room[kind] ? repalloc_huge(side->rows[kind], rows) : MemoryContextAllocHuge(context, rows);
  side->room[kind] = room;
}

static void take_row(struct side* side, MemoryContext context, HeapTuple tuple, TupleDesc columns) {
  bool no_row, no_shape;
  const Datum row = SPI_getbinval(tuple, columns, 1, &no_row);
  const Datum value = SPI_getbinval(tuple, columns, 2, &no_shape);
  MemoryContext before;
  struct shape shape;
  Size size;
  int64 at;
  if (no_row || no_shape) return;
  before = MemoryContextSwitchTo(context);  // vertices stay
  vshape_read(value, &shape);
  MemoryContextSwitchTo(before);
  size = record_size(shape.kind);
  at = side->used[shape.kind];
  if (at == side->room[shape.kind]) make_room(side, context, shape.kind);
  memcpy(side->records[shape.kind] + at * size, shape_data(&shape), size);
  side->rows[shape.kind][at] = *(ItemPointer)DatumGetPointer(row);
  side->used[shape.kind]++;
}

// Read by the snapshot of the query that the function stands in, as all else of it.
static void read_table(struct side* side, MemoryContext context, Oid type) {
  SPIPlanPtr plan = SPI_prepare(selection(side->table, type), 0, NULL);
  Portal rows = SPI_cursor_open(NULL, plan, NULL, NULL, true);
  do {
    SPI_cursor_fetch(rows, true, rows_a_fetch);
    for (uint64 i = 0; i < SPI_processed; i++) take_row(side, context, SPI_tuptable->vals[i], SPI_tuptable->tupdesc);
    SPI_freetuptable(SPI_tuptable);
    CHECK_FOR_INTERRUPTS();
  } while (SPI_processed > 0);
  SPI_cursor_close(rows);
}

// ---- Index and join ----

static void build_index(struct side* side, MemoryContext context) {
  int64_t count = 0, size, scratch_size, built;
  void* scratch;
  for (int32_t kind = 0; kind < kind_count; kind++) {
    vesica_shapes_from_records_f64(kind, side->used[kind], side->records[kind], (ptrdiff_t)record_size(kind),
                                   &side->sets[kind]);
    count += side->used[kind];
  }
  size = vesica_index_size(count);
  scratch_size = vesica_index_scratch(count);
  side->index = aligned_memory(context, size);
  scratch = aligned_memory(context, scratch_size);
  built = vesica_index_build_f64(side->sets, kind_count, side->index, size, scratch, scratch_size);
  if (built < 0) elog(ERROR, "vesica_join: %s", vesica_strerror((int32_t)built));
}

static ItemPointer row_of(const struct side* side, int64 item) {
  int32_t kind = 0;
  while (item >= side->used[kind]) item -= side->used[kind++];
  return &side->rows[kind][item];
}

static void put_pairs(const struct side* a, const struct side* b, MemoryContext context, ReturnSetInfo* out) {
  const int64_t scratch_size = vesica_join_scratch();
  void* scratch = aligned_memory(context, scratch_size);
  int64_t* first = palloc(2 * pairs_a_call * sizeof *first);
  int64_t *second = first + pairs_a_call, state[4] = {0, 0, 0, 0};
  while (state[0] != -1) {
    const int64_t found = vesica_join_f64(VESICA_JOIN_OVERLAP, a->index, a->sets, kind_count, b->index, b->sets,
                                          kind_count, 0, 1, scratch, scratch_size, first, second, pairs_a_call, state);
    if (found < 0) elog(ERROR, "vesica_join: %s", vesica_strerror((int32_t)found));
    for (int64_t i = 0; i < found; i++) {
      Datum values[2] = {PointerGetDatum(row_of(a, first[i])), PointerGetDatum(row_of(b, second[i]))};
      bool nulls[2] = {false, false};
      tuplestore_putvalues(out->setResult, out->setDesc, values, nulls);
    }
    CHECK_FOR_INTERRUPTS();
  }
}

// The extension's type, wherever it was put: the one in the schema of this function.
static Oid shape_type(FunctionCallInfo fcinfo) {
  const Oid schema = get_func_namespace(fcinfo->flinfo->fn_oid);
  const Oid type = GetSysCacheOid2(TYPENAMENSP, Anum_pg_type_oid, CStringGetDatum("vshape"), ObjectIdGetDatum(schema));
  if (!OidIsValid(type)) elog(ERROR, "vesica_join: no type vshape beside it");
  return type;
}

PG_FUNCTION_INFO_V1(vesica_join);
Datum vesica_join(PG_FUNCTION_ARGS) {
  MemoryContext context = CurrentMemoryContext;
  const Oid type = shape_type(fcinfo);
  struct side* sides = palloc0(2 * sizeof *sides);
  const int count = PG_GETARG_OID(0) == PG_GETARG_OID(1) ? 1 : 2;
  InitMaterializedSRF(fcinfo, 0);
  SPI_connect();
  for (int i = 0; i < count; i++) {
    sides[i].table = PG_GETARG_OID(i);
    read_table(&sides[i], context, type);
    build_index(&sides[i], context);
  }
  put_pairs(&sides[0], &sides[count - 1], context, (ReturnSetInfo*)fcinfo->resultinfo);
  SPI_finish();
  return (Datum)0;
}
