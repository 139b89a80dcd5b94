#lang racket/base
;; The process that evaluates cells, as the kernel of a notebook talks to it: by a protocol on
;; descriptors 3 and 4.  A shell makes them of its standard input and output, for Racket hands down
;; no others.

(require compiler/find-exe
         json
         racket/match
         (only-in racket/port read-line-evt)
         "patience.rkt")

(provide start-cells end-cells send-to receive-from
         cells-number run-cell answers-to texts bundles outcome)

;; process; in : what it sends; out : what it is sent
(struct cells (process in out [number #:mutable]))

(define command
  (string-append "exec 3<&0 4>&1 0</dev/null 1>&2; "
                 "exec \"$0\" -l mechanics/notebook/cell-process -- 3 4"))

(define (start-cells)
  (define-values (process in out errors)
    (subprocess #f #f (current-error-port) "/bin/sh" "-c" command (find-exe)))
  (define c (cells process in out 0))
  (match (receive-from c) [(hash-table ('kind "ready")) c]))

(define (end-cells c)
  (close-output-port (cells-out c))
  (sync/patience 30 (cells-process c))
  (subprocess-status (cells-process c)))

(define (send-to c . fields)
  (define text (jsexpr->bytes (apply hasheq fields)))
  (fprintf (cells-out c) "~a\n" (bytes-length text))
  (write-bytes text (cells-out c))
  (flush-output (cells-out c)))

(define (receive-from c)
  (define length (sync/patience 60 (read-line-evt (cells-in c))))
  (unless (string? length) (error 'cells "no message came"))
  (bytes->jsexpr (read-bytes (string->number length) (cells-in c))))

;; during : message -> void, called with each message that comes before the last
;; -> list of messages, the last of which says how the cell ended
(define (run-cell c code [during void])
  (set-cells-number! c (add1 (cells-number c)))
  (send-to c 'do "cell" 'id (cells-number c) 'code code)
  (rest-of c during))

(define (answers-to c do . fields)
  (apply send-to c 'do do 'id 0 fields)
  (car (rest-of c void)))

(define (rest-of c during)
  (define m (receive-from c))
  (cond [(equal? (hash-ref m 'kind) "done") (list m)]
        [else
         (during m)
         (cons m (rest-of c during))]))

;; ---------------------------------------------------------------------------
;; Of the messages of a cell

;; The text written on a stream
(define (texts messages name)
  (apply string-append
         (for/list ([m (in-list messages)]
                    #:when (and (equal? (hash-ref m 'kind) "stream")
                                (equal? (hash-ref m 'name) name)))
           (hash-ref m 'text))))

;; The results shown, in a format
(define (bundles messages type)
  (for/list ([m (in-list messages)] #:when (equal? (hash-ref m 'kind) "shown"))
    (hash-ref (hash-ref m 'data) (string->symbol type) #f)))

;; 'ok, or the message of the failure and its line
(define (outcome messages)
  (match (car (reverse messages))
    [(hash-table ('status "ok")) 'ok]
    [(hash-table ('message message) ('line line)) (list message line)]))
