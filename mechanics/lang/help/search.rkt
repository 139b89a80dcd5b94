#lang racket/base
;; The search of the table.  Each word of a question adds its weight to the findings that have it;
;; those that have the most words come first, then those of the greatest sum.
;;
;; The manual's pages do the same (scribblings/mechanics/look/search.js), and are tested to find
;; the same.  So all is done in whole numbers, and equals stay in the order of the table.

(require racket/list
         racket/string
         "finding.rkt" "words.rkt"
         (only-in "../../error/spelling.rkt" likely-names))

(provide find-in-table        ; table, text -> findings, the best first, and whether all words fit
         respelled)           ; table, text -> text of words that fit, or #f

(define (find-in-table table text)
  (define words (asked-words table text))
  (define scores                        ; place -> (words . sum)
    (for*/fold ([scores (hasheqv)]) ([w (in-list words)]
                                     [(k weight) (in-hash (weights-of table w))])
      (hash-update scores k (lambda (s) (cons (add1 (car s)) (+ (cdr s) weight))) '(0 . 0))))
  (define most (apply max 0 (map car (hash-values scores))))
  (define found
    (for/list ([(k s) (in-hash scores)] #:when (= (car s) most))
      (cons (+ (cdr s) (bonus table k text)) k)))
  (values (one-of-each-page
           (for/list ([f (in-list (sort found before?))])
             (vector-ref (vector-ref table 0) (cdr f))))
          (= most (length words))))

;; Of a page and its sections the best.
(define (one-of-each-page found)
  (remove-duplicates found #:key (lambda (f)
                                   (if (memq (finding-kind f) '(page section))
                                       (car (string-split (finding-where f) "#"))
                                       f))))

;; In the order of the table, which has longer phrases before those that they contain.
(define (asked-words table text)
  (define spaced (lambda (t) (string-append " " t " ")))
  (remove-duplicates
   (string-split
    (for/fold ([t (spaced (string-join (telling-words text)))])
              ([r (in-list (vector-ref table 4))])
      (string-replace t (spaced (car r)) (spaced (cdr r)))))))

(define (before? a b)
  (or (> (car a) (car b))
      (and (= (car a) (car b)) (< (cdr a) (cdr b)))))

;; A name equal to the text, but for joining words, comes first of all; not so words that draw.
(define (bonus table k text)
  (define f (vector-ref (vector-ref table 0) k))
  (define typed (string-trim text))
  (+ (bytes-ref (vector-ref table 1) k)
     (cond [(not (named? f)) 0]
           [(string=? (finding-title f) typed) 2000]
           [(member (plain (finding-title f)) (list (plain typed) (telling-text typed))) 1000]
           [else 0])))

(define (named? f)
  (or (eq? (finding-kind f) 'page)
      (and (eq? (finding-kind f) 'name)
           (member (finding-where f) '("mechanics" "mechanics/scmutils" "mechanics/book")))))

;; ---------------------------------------------------------------------------
;; A word

(define shortest-part 3)
(define shortest-beginning 4)
(define longest-rest 2)

;; -> hash, place to weight: of the word, half of its synonyms, a third of words it begins, a
;; quarter of a word that is its beginning
(define (weights-of table w)
  (for*/fold ([weights (hasheqv)])
             ([(term postings) (in-hash (vector-ref table 2))]
              [part (in-value (share table w term))] #:when part
              [i (in-range 0 (bytes-length postings) 3)])
    (define k (+ (* 256 (bytes-ref postings i)) (bytes-ref postings (add1 i))))
    (define weight (quotient (bytes-ref postings (+ i 2)) part))
    (hash-update weights k (lambda (v) (max v weight)) 0)))

(define (share table w term)
  (define n (string-length w))
  (define m (string-length term))
  (cond [(string=? w term) 1]
        [(member term (hash-ref (vector-ref table 3) w '())) 2]
        [(regexp-match? #px"^[\\d.]+$" w) #f]
        [(and (>= n shortest-part) (string-prefix? term w)) 3]
        [(and (>= m shortest-beginning) (<= (- n m) longest-rest) (string-prefix? w term)) 4]
        [else #f]))

;; ---------------------------------------------------------------------------
;; Words misspelt

;; The text with a likely word of a title in place of each word that fits nothing, or #f where there
;; is none.
(define (respelled table text)
  (define known
    (remove-duplicates
     (for*/list ([f (in-vector (vector-ref table 0))] [w (in-list (all-words (finding-title f)))])
       (string->symbol w))))
  (define typed (string-split (telling-text text)))
  (define spelt                         ; lists of words
    (for/list ([w (in-list typed)])
      (if (hash-empty? (weights-of table (car (words-of w))))
          (map symbol->string (likely-names (string->symbol w) known))
          (list w))))
  (and (andmap pair? spelt)
       (not (equal? (map car spelt) typed))
       (string-join (map car spelt))))
