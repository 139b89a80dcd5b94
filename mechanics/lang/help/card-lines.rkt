#lang racket/base
;; A card as text, in lines of at most so many columns:
;;
;;     (iota n [start] [step])  → list
;;       The list of n values from start on, each larger by step.
;;
;;       n      0, 1, 2 …
;;
;;       > (iota 4)
;;       '(0 1 2 3)
;;
;;       See also: …

(require racket/list
         racket/string
         "card.rkt" "demonstration.rkt")

(provide card-lines call-lines filled indented)

(define indentation "  ")

(define (card-lines c width)
  (define inside (- width (string-length indentation)))
  (define paragraphs
    (list (append (filled (string-split (or (card-sentence c) "")) inside)
                  (library-lines c))
          (argument-lines (append-map arguments-told (card-signatures c)) inside)
          (example-lines (card-demonstration c) inside)
          (reference-lines c inside)))
  (append (append-map (lambda (s) (call-lines s width)) (card-signatures c))
          (indented (add-between-lines paragraphs))))

(define (indented lines [by indentation])
  (for/list ([l (in-list lines)]) (if (string=? l "") l (string-append by l))))

(define (add-between-lines paragraphs)
  (append* (add-between (filter pair? paragraphs) '(""))))

;; ---------------------------------------------------------------------------
;; The call, and what it takes

(define (call-lines s width)
  (define result (signature-result s))
  (filled (append (signature-call s) (if result (cons " →" (string-split result)) '()))
          width
          (string-append "    " indentation)))

(define (library-lines c)
  (if (eq? (card-library c) 'mechanics)
      '()
      (list (format "(require ~a) provides it." (card-library c)))))

(define (arguments-told s)
  (filter (lambda (a) (or (argument-default a) (tells? (argument-what a))))
          (append (signature-needed s) (signature-optional s) (signature-keywords s))))

(define (tells? what) (not (member what '("value" "any value"))))

;; A line for each name, in columns.
(define (argument-lines arguments width)
  (define named (remove-duplicates arguments #:key argument-name))
  (define room (apply max 0 (map (lambda (a) (string-length (argument-name a))) named)))
  (append*
   (for/list ([a (in-list named)])
     (define margin (make-string (+ room 3) #\space))
     (define name (argument-name a))
     (define lines (filled (string-split (told a)) (- width room 3)))
     (cons (string-append (pad name (+ room 3)) (car lines)) (indented (cdr lines) margin)))))

(define (told a)
  (define default (argument-default a))
  (cond [(not default) (argument-what a)]
        [(equal? default "#f") (without-false (argument-what a))]
        [(tells? (argument-what a)) (format "~a; ~a unless given" (argument-what a) default)]
        [else (format "~a unless given" default)]))

;; "constraint, list or #f" -> "constraint or list"; commas before an arrow are between arguments
(define (without-false what)
  (define found (regexp-match #rx"^(.*) or #f$" what))
  (if found
      (regexp-replace #rx", ([^,→]*)$" (cadr found) " or \\1")
      what))

(define (pad text n) (string-append text (make-string (- n (string-length text)) #\space)))

;; ---------------------------------------------------------------------------
;; The example

(define (example-lines e width)
  (if e
      (append (append-map lines-of (example-definitions e))
              (append-map answer-lines (demonstrate e width)))
      '()))

(define (answer-lines a)
  (define typed (lines-of (answer-typed a)))
  (append (cons (string-append "> " (car typed)) (indented (cdr typed)))
          (lines-of (answer-printed a))))

(define (lines-of text) (string-split text "\n"))

;; ---------------------------------------------------------------------------
;; Where to read on

(define (reference-lines c width)
  (define also (card-also c))
  (append
   (filled (string-split (format "~aManual: ~a."
                                 (if (card-place c) (format "Book: ~a. " (card-place c)) "")
                                 (card-page c)))
           width)
   (if (null? also)
       '()
       (filled (cons "See also:" (separated (map symbol->string also))) width))))

(define (separated texts)
  (append (map (lambda (t) (string-append t ",")) (drop-right texts 1))
          (list (string-append (last texts) "."))))

;; Words put into lines, of which those after the first begin with `margin`.
(define (filled words width [margin ""])
  (for/fold ([lines '()] [line #f]
             #:result (reverse (if line (cons line lines) lines)))
            ([word (in-list words)])
    (cond [(not line) (values lines word)]
          [(<= (+ (string-length line) 1 (string-length word)) width)
           (values lines (string-append line " " word))]
          [else (values (cons line lines) (string-append margin word))])))
