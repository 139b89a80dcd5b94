#lang racket/base
;; JSON that anybody may have written, read without harm.
;;
;; A text may be nested deeper than a reader can follow, hold a number that would fill the memory,
;; or give an object one key twice, of which readers take different ones.  So the text is looked
;; through before it is read: each byte once, with little memory.

(require json)

(provide read-bounded-JSON)

(define deepest 64)
(define most-values 200000)
(define longest-number 40)       ; characters

;; text : bytes; refuse : text -> none -> jsexpr, or eof
(define (read-bounded-JSON text refuse)
  (define body (regexp-replace #rx#"^\357\273\277" text #""))
  (look-through body refuse)
  (with-handlers ([exn:fail:read? (lambda (e) (refuse "its JSON has a mistake"))])
    (bytes->jsexpr body)))

;; keys : of the objects that are open, innermost first; #f for a list
(define (look-through text refuse)
  (define n (bytes-length text))
  (let loop ([i 0] [keys '()] [values 0])
    (when (> (length keys) deepest)
      (refuse (format "its JSON is nested more than ~a deep" deepest)))
    (when (> values most-values)
      (refuse (format "its JSON holds more than ~a values" most-values)))
    (when (< i n)
      (define next (+ i 1))
      (case (integer->char (bytes-ref text i))
        [(#\{) (loop next (cons (make-hash) keys) (+ values 1))]
        [(#\[) (loop next (cons #f keys) (+ values 1))]
        [(#\} #\]) (loop next (if (pair? keys) (cdr keys) '()) values)]
        [(#\,) (loop next keys (+ values 1))]
        [(#\")
         (define end (string-end text next))
         (when (and (pair? keys) (car keys) (regexp-match? #px#"^\\s*:" text end))
           (note-key! (car keys) (subbytes text i end) refuse))
         (loop end keys values)]
        [(#\0 #\1 #\2 #\3 #\4 #\5 #\6 #\7 #\8 #\9) (loop (number-end text i refuse) keys values)]
        [else (loop next keys values)]))))

;; i : behind the opening quotation mark -> position behind the closing one
(define (string-end text i)
  (define b (if (< i (bytes-length text)) (bytes-ref text i) #f))
  (cond [(not b) (bytes-length text)]
        [(= b 34) (+ i 1)]
        [(= b 92) (string-end text (+ i 2))]
        [else (string-end text (+ i 1))]))

;; An exponent of three digits is a number that no notebook needs, but one that a flonum holds.
(define (number-end text i refuse)
  (define m (regexp-match #rx#"^[0-9.eE+-]+" text i))
  (when (or (> (bytes-length (car m)) longest-number) (regexp-match? #px#"[eE][+-]?\\d{4}" (car m)))
    (refuse "its JSON holds a number with too many digits"))
  (+ i (bytes-length (car m))))

;; A key may be written with escapes: the text that it means is compared.
(define (note-key! keys literal refuse)
  (define key (with-handlers ([exn:fail? (lambda (e) (refuse "its JSON has a mistake"))])
                (bytes->jsexpr literal)))
  (when (hash-ref keys key #f)
    (refuse (format "the key ~s stands twice in one object of its JSON" key)))
  (hash-set! keys key #t))
