#lang racket/base
;; Notebooks as files: cells in Jupyter's format, version 4.5, a cell a line.
;;
;; The rest of a program, beside its cells' sources, is in their metadata, under `mechanics`: the
;; text as it stands in the program, and that behind it.  Outputs are written where a notebook is
;; run as it is made; they are not read.

(require json
         racket/list
         racket/match
         racket/string
         "bounded-JSON.rkt" "program-cells.rkt"
         "../../error/complain.rkt")

(provide notebook->bytes bytes->notebook)

;; outputs : a list for each cell, of those that were run, or '(); folded? : is the source of a cell
;; to be shown only where it is asked for?
(define (notebook->bytes header cells [outputs (map (lambda (_) '()) cells)]
                         #:folded? [folded? (lambda (c) #f)])
  (define parts
    (for/list ([c (in-list cells)] [k (in-naturals 1)] [o (in-list outputs)])
      (jsexpr->bytes (cell->json c k o (= k (length cells)) (folded? c)))))
  (define metadata
    (hasheq 'kernelspec (hasheq 'name "mechanics" 'display_name "mechanics" 'language "racket")
            'language_info (hasheq 'name "racket" 'file_extension ".rkt")
            'mechanics (hasheq 'header header)))
  (bytes-append #"{\"cells\": [\n" (join-bytes parts #",\n") #"\n],\n\"metadata\": "
                (jsexpr->bytes metadata) #",\n\"nbformat\": 4,\n\"nbformat_minor\": 5\n}\n"))

(define (join-bytes parts between) (apply bytes-append (add-between parts between)))

(define (cell->json c k outputs last? folded?)
  (define kind (cell-kind c))
  (define usual-after (if last? "\n" usual-gap))
  (define-values (text after) (values (cell-text c) (cell-after c)))
  (define kept
    (table 'text (and (not (equal? text (cell-source c))) text)
           'after (and (not (equal? after usual-after)) after)))
  (define fields
    (hasheq 'id (format "cell-~a" k)
            'cell_type (symbol->string kind)
            'metadata (table 'mechanics (and (not (hash-empty? kept)) kept)
                             'jupyter (and folded? (hasheq 'source_hidden #t)))
            'source (cell-source c)))
  (if (eq? kind 'code) (hash-set* fields 'execution_count 'null 'outputs outputs) fields))

;; Without those that are #f
(define (table . keys+values)
  (for/hasheq ([(key value) (in-hash (apply hasheq keys+values))] #:when value) (values key value)))

;; ---------------------------------------------------------------------------
;; Reading

;; -> header and cells.  name : of the file, for messages; attachments? : may cells have some, which
;; are left out?
(define (bytes->notebook who name text #:attachments? [attachments? #t])
  (define (refuse why) (complain who "~a is no notebook of Jupyter, in its format 4~a" name why))
  (define x (read-bounded-JSON text (lambda (why) (refuse (string-append ": " why)))))
  (define cells (and (hash? x) (hash-ref x 'cells #f)))
  (unless (and (list? cells) (andmap hash? cells)) (refuse ""))
  ;; metadata that would bring in parts that no cell shows are not taken
  (define header (text-at x '(metadata mechanics header) usual-header))
  (values (if (header? header) header usual-header)
          (for/list ([c (in-list cells)])
            (unless (or attachments? (member (hash-ref c 'attachments #f) '(#f #hasheq())))
              (complain who about-attachments))
            (json->cell who c))))

(define about-attachments
  "a cell holds an attachment, such as a picture that was pasted, which is not read; take it out")

(define (json->cell who c)
  (define kind
    (match (hash-ref c 'cell_type #f)
      ["code" 'code]
      ["markdown" 'markdown]
      ["raw" 'raw]
      [other (complain who "a cell of an unknown kind: ~s" other)]))
  (define source (source->text who (hash-ref c 'source "")))
  (cell kind source
        (text-at c '(metadata mechanics text) source)
        (let ([after (text-at c '(metadata mechanics after) #f)])
          (and after (gap? after) after))))

;; A text, or its lines
(define (source->text who x)
  (cond [(string? x) x]
        [(and (list? x) (andmap string? x)) (string-append* x)]
        [else (complain who "the source of a cell is a text or a list of lines")]))

(define (text-at x keys otherwise)
  (cond [(null? keys) (if (string? x) x otherwise)]
        [(hash? x) (text-at (hash-ref x (car keys) #f) (cdr keys) otherwise)]
        [else otherwise]))
